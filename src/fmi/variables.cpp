#include "fmi/variables.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "programs/program.h"
#include "programs/summary.h"

namespace cli {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_meant(const std::string& part, const std::string& field) {
  const std::string inside = '/' + field + '/';
  return inside.find('/' + part + '/') != std::string::npos;
}

std::vector<mimo_field> chosen(const mimo::Layout& layout, const std::string& outputs) {
  const std::vector<mimo_field> fields = layout.fields();
  const std::vector<std::string> parts = outputs == "none" ? std::vector<std::string>() : parts_of(outputs);
  std::string names;
  for (const mimo_field& field : fields) names += (names.empty() ? "" : ", ") + std::string(field.name);
  for (const std::string& part : parts) {
    const bool usual = outputs == UnitOptions().outputs;
    const bool there =
        std::any_of(fields.begin(), fields.end(), [&](const auto& it) { return is_meant(part, it.name); });
    if (!there && !usual) throw Failure("--outputs: the world has no '" + part + "'; it has " + names);
  }
  std::vector<mimo_field> found;
  for (const mimo_field& field : fields) {
    if (std::any_of(parts.begin(), parts.end(), [&](const auto& part) { return is_meant(part, field.name); })) {
      found.push_back(field);
    }
  }
  return found;
}

std::string told(const mimo_field& field, const std::string& what) {
  const std::string frame = *field.frame == 0 ? "" : ", in the frame " + std::string(field.frame);
  const std::string late = field.end == 0 ? "" : text(", %g s after the end of a step", field.end);
  return what + frame + late;
}

std::vector<std::string> labels_of(const mimo::Layout& layout, const mimo_field& field, std::size_t count) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < count; ++i) {
    labels.push_back(layout.label(field.name, i));
    if (labels.back().empty()) return {};
  }
  return labels;
}

// "[3,1]", from 0.
std::string index_of(std::size_t element, const std::vector<std::size_t>& sizes) {
  std::string index;
  for (std::size_t axis = sizes.size(); axis-- > 0; element /= sizes[axis]) {
    index = std::to_string(element % sizes[axis]) + (index.empty() ? "" : ",") + index;
  }
  return '[' + index + ']';
}

Variable variable_of(const mimo_field& field) {
  Variable it;
  it.kind = Variable::kField;
  it.name = field.name;
  it.unit = field.unit;
  it.dtype = field.dtype;
  it.shape = shape(field);
  it.place = field.offset;
  it.count = std::accumulate(it.shape.begin(), it.shape.end(), std::size_t{1}, std::multiplies<>());
  it.low = field.low;
  it.high = field.high;
  return it;
}

// In FMI 3 a field is an array, and a picture in colour is bytes. In FMI 2 each element is a variable.
void add_field(const mimo::Layout& layout, const mimo_field& field, int version, std::vector<Variable>& all) {
  Variable whole = variable_of(field);
  const std::vector<std::string> labels = labels_of(layout, field, whole.count);
  const bool picture = field.ndim == 3 && field.receptors == 0 && labels.empty();
  if (version == 3) {
    std::string elements;
    for (const std::string& label : labels) elements += (elements.empty() ? ": " : ", ") + label;
    if (picture && field.dtype == MIMO_U8) whole.kind = Variable::kPicture;
    whole.description = told(field, shape_text(field) + elements);
    all.push_back(std::move(whole));
    return;
  }
  if (picture) return;
  const std::size_t bytes = field.bytes / whole.count;
  for (std::size_t i = 0; i < whole.count; ++i) {
    Variable one = whole;
    one.name += labels.empty() ? index_of(i, whole.shape) : '/' + labels[i];
    one.description = told(field, std::string("of ") + field.name);
    one.shape.clear();
    one.place += i * bytes;
    one.count = 1;
    all.push_back(std::move(one));
  }
}

Variable make(Variable::Kind kind, const std::string& name, const std::string& unit, const std::string& description,
              std::size_t place = 0, double low = -kInfinity, double high = kInfinity) {
  Variable it;
  it.kind = kind;
  it.name = name;
  it.unit = unit;
  it.description = description;
  it.place = place;
  it.low = low;
  it.high = high;
  return it;
}

}  // namespace

const char* Variable::type(int version) const {
  if (kind == kTerminated || kind == kTruncated) return "Boolean";
  const bool whole = kind == kField && dtype == MIMO_I32;
  if (version == 2) return whole || kind == kSeed ? "Integer" : "Real";
  if (kind == kPicture) return "Binary";
  if (kind == kSeed) return "UInt64";
  if (kind == kField && dtype == MIMO_U8) return "UInt8";
  if (kind == kField && dtype == MIMO_F32) return "Float32";
  return whole ? "Int32" : "Float64";
}

void add_unit_options(CLI::App& command, UnitOptions& options) {
  options.world.touch = "";  // the scene's own
  add_vision_options(command, options.world, "the scene's own");
  add_foveation_option(command, options.world);
  add_touch_option(command, options.world);
  add_senses_option(command, options.world);
  add_reflexes_option(command, options.world);
  command.add_option("--outputs", options.outputs, "Fields that a unit gives: senses and names of fields, or none")
      ->type_name("LIST")
      ->capture_default_str();
  command.add_option("--fmi", options.version, "Version of FMI, 2 or 3")
      ->type_name("N")
      ->check(CLI::IsMember({2, 3}).description(""))
      ->capture_default_str();
}

mimo::Env open_unit_world(const UnitOptions& options) { return open_own_world(options.world, make_env_config()); }

std::vector<Variable> variables_of(const mimo::Env& env, const UnitOptions& options) {
  const mimo::Layout layout = env.layout();
  std::vector<Variable> all;
  all.push_back(make(Variable::kTime, "time", "s", "simulated time"));
  all.push_back(make(Variable::kSeed, "seed", "", "of everything random"));
  const std::vector<mimo_action> actions = layout.actions();
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const mimo_action& it = actions[i];
    all.push_back(make(Variable::kAction, it.name, it.unit, "an action, held during a step", i, it.low, it.high));
  }
  for (const mimo_field& field : chosen(layout, options.outputs)) add_field(layout, field, options.version, all);
  const std::vector<mimo_agent_info> agents = env.agents();
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const std::string name = prefix(agents[i]);
    all.push_back(make(Variable::kReward, name + "reward", "", "of the last step", i));
    all.push_back(make(Variable::kTerminated, name + "terminated", "", "the episode has ended", i));
    all.push_back(make(Variable::kTruncated, name + "truncated", "", "the episode was cut off", i));
  }
  return all;
}

}  // namespace cli
