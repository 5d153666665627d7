#include "programs/policy_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/nearest.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string>;

constexpr const char* kFormat = "mimo-policy";
constexpr std::size_t kMostRows = 4096;  // of a layer: a file is no place to run out of memory
constexpr std::size_t kMostPeriods = 64;
constexpr int kMostNested = 16;  // nlohmann copies and prints nested values by calls of calls

const Names& members_of_version_2() {
  static const Names names = {"age", "delays", "hold_s", "clock_s", "reflex"};
  return names;
}

const Names& members() {
  static const Names names = {"format",  "version", "what",      "scene",   "step_seconds", "fields",
                              "actions", "mean",    "deviation", "clip",    "layers",       "how",
                              "age",     "delays",  "hold_s",    "clock_s", "reflex"};
  return names;
}

std::string joined(const Names& names) {
  std::string all;
  for (const std::string& name : names) all.append(all.empty() ? "" : ", ").append(name);
  return all;
}

std::string said(const Json& value) { return shortened(value.dump(-1, ' ', false, Json::error_handler_t::replace)); }

void refuse_unknown(const std::string& file, const Json& content, const Names& known, const char* owner) {
  for (const auto& [name, value] : content.items()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string meant = mimo::nearest(name, known);
    refuse_policy(file,
                  text("%s has no member \"%s\"%s; expected %s", owner, shortened(name).c_str(),
                       meant.empty() ? "" : (", did you mean \"" + meant + "\"?").c_str(), joined(known).c_str()));
  }
}

// Version 1 had members that nobody knew, and they were passed over.
void check_members(const std::string& file, const Json& content) {
  const Json version = content.value("version", Json());
  if (version == 2) {
    refuse_unknown(file, content, members(), "a policy");
    for (const char* name : {"what", "scene"}) {
      const Json value = content.value(name, Json(""));
      if (!value.is_string()) refuse_policy(file, text("\"%s\" is %s, expected text", name, said(value).c_str()));
    }
    return;
  }
  if (version != 1) {
    refuse_policy(file, text("its version is %s, and this program reads versions 1 and 2", said(version).c_str()));
  }
  for (const std::string& name : members_of_version_2()) {
    if (content.contains(name)) refuse_policy(file, text("\"%s\" needs version 2, and its version is 1", name.c_str()));
  }
}

Json parsed(const std::string& file) {
  bool too_nested = false;
  const auto keep = [&](int depth, Json::parse_event_t /*event*/, const Json& /*value*/) {
    too_nested |= depth > kMostNested;
    return depth <= kMostNested;
  };
  Json content = Json::parse(read_file(file), keep, false);
  if (too_nested) refuse_policy(file, text("its values are nested more than %d times", kMostNested));
  if (content.is_discarded() || !content.is_object()) refuse_policy(file, "this is no JSON object");
  if (content.value("format", Json()) != kFormat) refuse_policy(file, text("\"format\" is not \"%s\"", kFormat));
  check_members(file, content);
  return content;
}

int value_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

// Bytes of base 64; nothing of what is none.
std::vector<unsigned char> bytes_of(const std::string& text) {
  std::vector<unsigned char> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const int value = value_of(c);
    if (value < 0) return {};
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> count & 0xff));
  }
  return bytes;
}

// Single precision, low byte first, in base 64; as many as expected, and all finite.
std::vector<float> numbers(const std::string& file, const Json& content, const char* name, std::size_t count) {
  const auto found = content.find(name);
  const auto bytes =
      found != content.end() && found->is_string() ? bytes_of(found->get<std::string>()) : std::vector<unsigned char>();
  if (bytes.size() != 4 * count) {
    refuse_policy(file, text("\"%s\" holds %zu bytes of base 64, expected %zu: %zu numbers", name, bytes.size(),
                             4 * count, count));
  }
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t byte = 4; byte-- > 0;) bits = bits << 8 | bytes[4 * i + byte];
    std::memcpy(&values[i], &bits, sizeof bits);
    if (!std::isfinite(values[i])) refuse_policy(file, text("\"%s\" holds what is no finite number", name));
  }
  return values;
}

// A matrix that was given row after row, column after column.
std::vector<float> turned(const std::vector<float>& matrix, std::size_t rows, std::size_t columns) {
  std::vector<float> turned(matrix.size());
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column)
      turned[column * rows + row] = matrix[row * columns + column];
  }
  return turned;
}

std::size_t size_in(const std::string& file, const Json& value, const char* what) {
  const std::uint64_t count = value.is_number_unsigned() ? value.get<std::uint64_t>() : 0;
  if (count < 1 || count > kMostRows)
    refuse_policy(file, text("%s is %s, expected 1 to %zu", what, said(value).c_str(), kMostRows));
  return static_cast<std::size_t>(count);
}

const Json& list_in(const std::string& file, const Json& content, const char* name, bool may_be_empty = false) {
  const auto found = content.find(name);
  if (found == content.end() || !found->is_array() || (found->empty() && !may_be_empty)) {
    refuse_policy(file, text("it has no list \"%s\"", name));
  }
  return *found;
}

bool is_single(const Json& value) {
  return value.is_number() && std::abs(value.get<double>()) <= std::numeric_limits<float>::max();
}

// A number that a single holds, above 0, or from 0 on.
double positive(const std::string& file, const Json& value, const char* name, bool or_zero = false) {
  const double number = is_single(value) ? value.get<double>() : -1;
  if (!(number > 0 || (or_zero && number == 0))) {
    refuse_policy(
        file, text("\"%s\" is %s, expected a number %s", name, said(value).c_str(), or_zero ? "from 0 on" : "above 0"));
  }
  return number;
}

// Shorter periods and longer holds are a mistake, and their quotients would end at infinity.
double seconds(const std::string& file, const Json& value, const char* name) {
  constexpr double kLeast = 1e-3, kMost = 1e6;
  const double number = value.is_number() ? value.get<double>() : 0;
  if (!(number >= kLeast && number <= kMost)) {
    refuse_policy(file, text("\"%s\" is %s, expected seconds from %g to %g", name, said(value).c_str(), kLeast, kMost));
  }
  return number;
}

double number_or(const std::string& file, const Json& content, const char* name, double otherwise) {
  const Json value = content.value(name, Json(otherwise));
  return value == otherwise ? otherwise : positive(file, value, name);
}

std::vector<std::string> names(const std::string& file, const Json& content, const char* name) {
  std::vector<std::string> found;
  for (const Json& one : list_in(file, content, name)) {
    if (!one.is_string()) refuse_policy(file, text("\"%s\" is no list of names", name));
    found.push_back(one.get<std::string>());
  }
  return found;
}

std::optional<double> age(const std::string& file, const Json& content) {
  if (!content.contains("age")) return std::nullopt;
  const Json& value = content["age"];
  const double months = value.is_number() ? value.get<double>() : -1;
  if (!(months >= 0 && months <= 24)) {
    refuse_policy(file, text("\"age\" is %s, expected months from 0 to 24", said(value).c_str()));
  }
  return months;
}

bool flag(const std::string& file, const Json& content, const char* name) {
  const Json value = content.value(name, Json(false));
  if (!value.is_boolean()) refuse_policy(file, text("\"%s\" is %s, expected true or false", name, said(value).c_str()));
  return value.get<bool>();
}

std::vector<double> periods(const std::string& file, const Json& content) {
  std::vector<double> found;
  if (!content.contains("clock_s")) return found;
  for (const Json& period : list_in(file, content, "clock_s", true)) {
    found.push_back(seconds(file, period, "clock_s"));
  }
  if (found.size() > kMostPeriods) {
    refuse_policy(file, text("\"clock_s\" has %zu periods, expected at most %zu", found.size(), kMostPeriods));
  }
  return found;
}

std::vector<PolicyFile::Field> fields(const std::string& file, const Json& content) {
  std::vector<PolicyFile::Field> found;
  for (const Json& field : list_in(file, content, "fields", content["version"] != 1)) {
    if (!field.is_array() || field.size() != 2 || !field[0].is_string()) {
      refuse_policy(file, "\"fields\" is no list of names and counts");
    }
    found.push_back({field[0].get<std::string>(), size_in(file, field[1], "a field's count")});
  }
  return found;
}

std::optional<PolicyFile::Reflex> reflex(const std::string& file, const Json& content, std::size_t actions) {
  const auto found = content.find("reflex");
  if (found == content.end()) return std::nullopt;
  if (!found->is_object()) refuse_policy(file, text("\"reflex\" is %s, expected an object", said(*found).c_str()));
  refuse_unknown(file, *found, {"stiffness", "damping", "joints", "start"}, "\"reflex\"");
  PolicyFile::Reflex reflex;
  reflex.stiffness = static_cast<float>(positive(file, found->value("stiffness", Json()), "stiffness"));
  reflex.damping = static_cast<float>(positive(file, found->value("damping", Json()), "damping", true));
  reflex.joints = names(file, *found, "joints");
  for (const Json& angle : list_in(file, *found, "start")) {
    if (!is_single(angle)) {
      refuse_policy(file, text("\"start\" holds %s, expected a finite number", said(angle).c_str()));
    }
    reflex.start.push_back(angle.get<float>());
  }
  for (const auto& [name, count] : {std::pair("joints", reflex.joints.size()), {"start", reflex.start.size()}}) {
    if (count == actions) continue;
    refuse_policy(
        file, text("\"%s\" of \"reflex\" has %zu elements, expected %zu, one for each action", name, count, actions));
  }
  return reflex;
}

}  // namespace

std::string shortened(std::string text) {
  std::size_t longest = 60;
  if (text.size() <= longest) return text;
  while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xc0) == 0x80)
    --longest;  // a letter's later bytes
  return text.replace(longest, std::string::npos, "...");
}

void refuse_policy(const std::string& file, const std::string& why) { throw Failure("policy " + file + ": " + why); }

PolicyFile read_policy(const std::string& file) {
  const Json content = parsed(file);
  PolicyFile policy;
  const Json scene = content.value("scene", Json(""));
  policy.scene = scene.is_string() ? scene.get<std::string>() : "";
  policy.age = age(file, content);
  policy.delays = flag(file, content, "delays");
  policy.step_seconds = number_or(file, content, "step_seconds", 0);
  policy.hold_s = content.contains("hold_s") ? seconds(file, content["hold_s"], "hold_s") : 0;
  policy.clip = static_cast<float>(number_or(file, content, "clip", 10));
  policy.fields = fields(file, content);
  policy.clock_s = periods(file, content);
  policy.actions = names(file, content, "actions");
  policy.reflex = reflex(file, content, policy.actions.size());
  std::size_t width = 2 * policy.clock_s.size();
  for (const auto& field : policy.fields) width += field.count;
  policy.mean = numbers(file, content, "mean", width);
  policy.deviation = numbers(file, content, "deviation", width);
  if (std::any_of(policy.deviation.begin(), policy.deviation.end(), [](float one) { return !(one > 0); })) {
    refuse_policy(file, "\"deviation\" holds a number that is not above 0");
  }
  for (const Json& layer : list_in(file, content, "layers")) {
    if (!layer.is_object()) refuse_policy(file, "\"layers\" is no list of layers");
    if (content["version"] != 1) refuse_unknown(file, layer, {"rows", "weights", "bias"}, "a layer");
    const std::size_t rows = size_in(file, layer.value("rows", Json()), "\"rows\" of a layer");
    policy.layers.push_back({rows, width, turned(numbers(file, layer, "weights", rows * width), rows, width),
                             numbers(file, layer, "bias", rows)});
    width = rows;
  }
  if (width != policy.actions.size()) {
    refuse_policy(file, text("its last layer has %zu rows, and it has %zu actions", width, policy.actions.size()));
  }
  return policy;
}

}  // namespace cli
