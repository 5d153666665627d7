#include "fmi/description.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "programs/text.h"

namespace cli {
namespace {

// Units in FMI's base units. What has no dimension, as dB, has its name alone.
struct Unit {
  const char *name, *base;
};

constexpr Unit kUnits[] = {{"rad", "rad=\"1\""},
                           {"rad/s", "rad=\"1\" s=\"-1\""},
                           {"m", "m=\"1\""},
                           {"m/s", "m=\"1\" s=\"-1\""},
                           {"m/s^2", "m=\"1\" s=\"-2\""},
                           {"s", "s=\"1\""},
                           {"N", "kg=\"1\" m=\"1\" s=\"-2\""},
                           {"Nm", "kg=\"1\" m=\"2\" s=\"-2\""},
                           {"Hz", "s=\"-1\""},
                           {"Pa", "kg=\"1\" m=\"-1\" s=\"-2\""},
                           {"degC", "K=\"1\" offset=\"273.15\""}};

std::string escaped(const std::string& plain) {
  std::string safe;
  for (const char c : plain) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + '"';
}

std::string number_attribute(const char* name, double value) { return attribute(name, text("%.17g", value)); }

std::string unit_definitions(const std::vector<Variable>& variables) {
  std::set<std::string> used;
  for (const Variable& it : variables) {
    if (!it.unit.empty()) used.insert(it.unit);
  }
  std::string xml;
  for (const std::string& name : used) {
    const auto known =
        std::find_if(std::begin(kUnits), std::end(kUnits), [&](const Unit& it) { return it.name == name; });
    xml += "    <Unit" + attribute("name", name);
    xml += known == std::end(kUnits) ? "/>\n" : std::string("><BaseUnit ") + known->base + "/></Unit>\n";
  }
  return xml.empty() ? "" : "  <UnitDefinitions>\n" + xml + "  </UnitDefinitions>\n";
}

std::string range_of(const Variable& it) {
  std::string xml = it.unit.empty() ? "" : attribute("unit", it.unit);
  if (std::isfinite(it.low)) xml += number_attribute("min", it.low);
  if (std::isfinite(it.high)) xml += number_attribute("max", it.high);
  return xml;
}

const char* causality_of(const Variable& it) {
  if (it.kind == Variable::kTime) return "independent";
  if (it.kind == Variable::kSeed) return "parameter";
  return it.is_input() ? "input" : "output";
}

const char* variability_of(const Variable& it) {
  if (it.kind == Variable::kTime) return "continuous";
  return it.kind == Variable::kSeed ? "fixed" : "discrete";
}

// Within the range, at rest.
double start_of(const Variable& it, std::uint64_t seed) {
  return it.kind == Variable::kSeed ? static_cast<double>(seed) : std::clamp(0.0, it.low, it.high);
}

std::string variable_2(const Variable& it, std::size_t number, std::uint64_t seed) {
  std::string xml =
      "    <ScalarVariable" + attribute("name", it.name) + attribute("valueReference", std::to_string(number));
  xml += attribute("description", it.description) + attribute("causality", causality_of(it)) +
         attribute("variability", variability_of(it));
  if (it.is_output()) xml += attribute("initial", "calculated");
  xml += std::string("><") + it.type(2);
  if (it.type(2) == std::string("Real")) xml += range_of(it);
  if (it.kind == Variable::kSeed) xml += attribute("start", std::to_string(seed));
  if (it.is_input()) xml += number_attribute("start", start_of(it, seed));
  return xml + "/></ScalarVariable>\n";
}

std::string variable_3(const Variable& it, std::size_t number, std::uint64_t seed) {
  std::string xml = std::string("    <") + it.type(3) + attribute("name", it.name);
  xml += attribute("valueReference", std::to_string(number)) + attribute("description", it.description) +
         attribute("causality", causality_of(it)) + attribute("variability", variability_of(it));
  const std::string type = it.type(3);
  if (type == "Float64" || type == "Float32") xml += range_of(it);
  if (it.kind == Variable::kSeed) xml += attribute("start", std::to_string(seed));
  if (it.is_input()) xml += number_attribute("start", start_of(it, seed));
  if (it.kind == Variable::kPicture) {
    return xml + attribute("mimeType", "application/octet-stream") + attribute("maxSize", std::to_string(it.count)) +
           "/>\n";
  }
  if (it.shape.empty()) return xml + "/>\n";
  xml += ">\n";
  for (const std::size_t size : it.shape) xml += "      <Dimension" + attribute("start", std::to_string(size)) + "/>\n";
  return xml + "    </" + type + ">\n";
}

// Outputs belong to the step that was made: they depend on no input of the same moment.
std::string structure(const std::vector<Variable>& variables, int version) {
  std::string outputs, initial;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (!variables[i].is_output()) continue;
    if (version == 3) {
      const std::string reference = attribute("valueReference", std::to_string(i)) + attribute("dependencies", "");
      outputs += "    <Output" + reference + "/>\n";
      initial += "    <InitialUnknown" + reference + "/>\n";
    } else {
      const std::string unknown =
          "      <Unknown" + attribute("index", std::to_string(i + 1)) + attribute("dependencies", "") + "/>\n";
      outputs += unknown;
      initial += unknown;
    }
  }
  if (version == 2 && !outputs.empty()) {
    outputs = "    <Outputs>\n" + outputs + "    </Outputs>\n";
    initial = "    <InitialUnknowns>\n" + initial + "    </InitialUnknowns>\n";
  }
  return "  <ModelStructure>\n" + outputs + initial + "  </ModelStructure>\n";
}

}  // namespace

std::string model_description(const UnitFacts& facts, const std::vector<Variable>& variables, int version) {
  constexpr double kSeconds = 10;  // what importers simulate that are not told otherwise
  const bool three = version == 3;
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription";
  xml += attribute("fmiVersion", three ? "3.0" : "2.0") + attribute("modelName", facts.name);
  xml += attribute(three ? "instantiationToken" : "guid", facts.token);
  xml += attribute("description", "MIMo, a simulated infant, task " + facts.task);
  xml += attribute("generationTool", "libmimo " + std::string(mimo_version()));
  xml += attribute("variableNamingConvention", "flat") + ">\n  <CoSimulation" +
         attribute("modelIdentifier", kUnitIdentifier);
  xml += attribute("canHandleVariableCommunicationStepSize", "true");
  xml += attribute(three ? "canGetAndSetFMUState" : "canGetAndSetFMUstate", "true");
  xml += attribute(three ? "canSerializeFMUState" : "canSerializeFMUstate", "true");
  if (three) xml += number_attribute("fixedInternalStepSize", facts.step);
  xml += "/>\n" + unit_definitions(variables);
  xml += std::string("  <LogCategories>\n    <Category") + attribute("name", "logStatusError") +
         "/>\n  </LogCategories>\n";
  xml += "  <DefaultExperiment" + number_attribute("startTime", 0) + number_attribute("stopTime", kSeconds) +
         number_attribute("stepSize", facts.step) + "/>\n  <ModelVariables>\n";
  for (std::size_t i = 0; i < variables.size(); ++i) {
    xml += three ? variable_3(variables[i], i, facts.seed) : variable_2(variables[i], i, facts.seed);
  }
  return xml + "  </ModelVariables>\n" + structure(variables, version) + "</fmiModelDescription>\n";
}

}  // namespace cli
