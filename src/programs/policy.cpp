#include "programs/policy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "programs/files.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/text.h"

namespace cli {
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "mimo-policy";
constexpr int kVersion = 1;
constexpr std::size_t kMostRows = 4096;  // of a layer: a file is no place to run out of memory
constexpr int kMostNested = 16;          // nlohmann copies and prints nested values by calls of calls

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw Failure("policy " + file + ": " + why);
}

Json parsed(const std::string& file) {
  bool too_nested = false;
  const auto keep = [&](int depth, Json::parse_event_t /*event*/, const Json& /*value*/) {
    too_nested |= depth > kMostNested;
    return depth <= kMostNested;
  };
  Json content = Json::parse(read_file(file), keep, false);
  if (too_nested) refuse(file, text("its values are nested more than %d times", kMostNested));
  if (content.is_discarded() || !content.is_object()) refuse(file, "this is no JSON object");
  if (content.value("format", Json()) != kFormat) refuse(file, text("\"format\" is not \"%s\"", kFormat));
  if (content.value("version", Json()) != kVersion) {
    refuse(file, text("its version is %s, and this program reads version %d",
                      content.value("version", Json()).dump().c_str(), kVersion));
  }
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
    refuse(file,
           text("\"%s\" holds %zu bytes of base 64, expected %zu: %zu numbers", name, bytes.size(), 4 * count, count));
  }
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t byte = 4; byte-- > 0;) bits = bits << 8 | bytes[4 * i + byte];
    std::memcpy(&values[i], &bits, sizeof bits);
    if (!std::isfinite(values[i])) refuse(file, text("\"%s\" holds what is no finite number", name));
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
    refuse(file, text("%s is %s, expected 1 to %zu", what, value.dump().c_str(), kMostRows));
  return static_cast<std::size_t>(count);
}

const Json& list_in(const std::string& file, const Json& content, const char* name) {
  const auto found = content.find(name);
  if (found == content.end() || !found->is_array() || found->empty()) {
    refuse(file, text("it has no list \"%s\"", name));
  }
  return *found;
}

std::size_t elements(const mimo_field& field) {
  std::size_t count = 1;
  for (const std::size_t length : shape(field)) count *= length;
  return count;
}

}  // namespace

Policy::Policy(const std::string& file) : file_(file) {
  const Json content = parsed(file);
  scene_ = content.value("scene", Json("")).is_string() ? content.value("scene", Json("")).get<std::string>() : "";
  const auto number = [&](const char* name, double otherwise) {
    const Json value = content.value(name, Json(otherwise));
    if (!value.is_number() || !(value.get<double>() > 0)) {
      if (value != otherwise) refuse(file, text("\"%s\" is %s, expected a number above 0", name, value.dump().c_str()));
    }
    return value.get<double>();
  };
  step_seconds_ = number("step_seconds", 0);
  clip_ = static_cast<float>(number("clip", 10));
  std::size_t width = 0;
  for (const Json& field : list_in(file, content, "fields")) {
    if (!field.is_array() || field.size() != 2 || !field[0].is_string()) {
      refuse(file, "\"fields\" is no list of names and counts");
    }
    fields_.push_back({field[0].get<std::string>(), size_in(file, field[1], "a field's count")});
    width += fields_.back().count;
  }
  for (const Json& action : list_in(file, content, "actions")) {
    if (!action.is_string()) refuse(file, "\"actions\" is no list of names");
    actions_.push_back(action.get<std::string>());
  }
  mean_ = numbers(file, content, "mean", width);
  deviation_ = numbers(file, content, "deviation", width);
  if (std::any_of(deviation_.begin(), deviation_.end(), [](float one) { return !(one > 0); })) {
    refuse(file, "\"deviation\" holds a number that is not above 0");
  }
  for (const Json& layer : list_in(file, content, "layers")) {
    if (!layer.is_object()) refuse(file, "\"layers\" is no list of layers");
    const std::size_t rows = size_in(file, layer.value("rows", Json()), "\"rows\" of a layer");
    layers_.push_back({rows, width, turned(numbers(file, layer, "weights", rows * width), rows, width),
                       numbers(file, layer, "bias", rows), std::vector<float>(rows)});
    width = rows;
  }
  if (width != actions_.size()) {
    refuse(file, text("its last layer has %zu rows, and it has %zu actions", width, actions_.size()));
  }
  seen_.resize(mean_.size());
  commands_.resize(actions_.size());
}

void Policy::attach(const mimo::Env& env) {
  const double step = env.timestep() * env.frame_skip();
  if (step_seconds_ > 0 && std::abs(step - step_seconds_) > 1e-9) {
    refuse(file_, text("it was learned with steps of %g s, and the world's last %g s", step_seconds_, step));
  }
  const auto& layout = env.layout();
  for (Field& field : fields_) {
    const auto& all = layout.fields();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const mimo_field& one) { return field.name == one.name; });
    if (found == all.end()) refuse(file_, text("the world has no field \"%s\"", field.name.c_str()));
    if (found->dtype != MIMO_F32) refuse(file_, text("field \"%s\" holds no 32-bit numbers", field.name.c_str()));
    if (elements(*found) != field.count) {
      refuse(file_, text("field \"%s\" has %zu numbers in this world, and %zu in the policy: another body, other "
                         "senses or other motors",
                         field.name.c_str(), elements(*found), field.count));
    }
    field.place = *found;
  }
  const auto& actions = layout.actions();
  if (actions.size() != actions_.size()) {
    refuse(file_, text("the world has %zu actions, and the policy %zu", actions.size(), actions_.size()));
  }
  bounds_.clear();
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    if (actions_[i] != actions[i].name) {
      refuse(file_, text("action %zu is \"%s\" in this world, and \"%s\" in the policy", i, actions[i].name,
                         actions_[i].c_str()));
    }
    bounds_.push_back({static_cast<float>(actions[i].low), static_cast<float>(actions[i].high)});
  }
}

const std::vector<float>& Policy::act(const mimo::Block& block) {
  std::size_t at = 0;
  for (const Field& field : fields_) {
    for (const float value : block.view<float>(field.place)) {
      seen_[at] = std::clamp((value - mean_[at]) / deviation_[at], -clip_, clip_);
      ++at;
    }
  }
  const std::vector<float>* in = &seen_;
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    Layer& layer = layers_[l];
    layer.out = layer.bias;
    for (std::size_t column = 0; column < layer.columns; ++column) {
      const float* weights = layer.weights.data() + column * layer.rows;
      const float value = (*in)[column];
      for (std::size_t row = 0; row < layer.rows; ++row) layer.out[row] += weights[row] * value;
    }
    if (l + 1 < layers_.size()) {
      for (float& one : layer.out) one = std::tanh(one);
    }
    in = &layer.out;
  }
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const Bounds& bounds = bounds_[i];
    commands_[i] = bounds.low + (bounds.high - bounds.low) * (std::clamp((*in)[i], -1.0F, 1.0F) + 1) / 2;
  }
  return commands_;
}

}  // namespace cli
