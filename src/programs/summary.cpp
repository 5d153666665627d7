#include "programs/summary.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "programs/program.h"
#include "programs/senses.h"

namespace cli {
namespace {

bool is_off_by_default(const std::string& sense) {
  const mimo_agent_config usual = mimo::agent_config();
  return std::any_of(std::begin(kSenses), std::end(kSenses),
                     [&](const Sense& one) { return one.name == sense && usual.*one.bits == 0; });
}

}  // namespace

std::vector<std::pair<std::string, double>> split_ms(const mimo_timing& timing, double total_ms) {
  const double scale = timing.steps == 0 ? 0 : 1000.0 / static_cast<double>(timing.steps);
  std::vector<std::pair<std::string, double>> split;
  for (const auto& [name, seconds] : kTimes) {
    if (timing.*seconds > 0 || !is_off_by_default(name)) split.emplace_back(name, timing.*seconds * scale);
  }
  double other = total_ms;
  for (const auto& part : split) other -= part.second;
  split.emplace_back("other", other);
  return split;
}

void FieldStatistics::add(const mimo::Block& block) {
  switch (field_.dtype) {
    case MIMO_U8: return add_values<std::uint8_t>(block);
    case MIMO_I32: return add_values<std::int32_t>(block);
    case MIMO_F32: return add_values<float>(block);
    case MIMO_F64: return add_values<double>(block);
    default: throw Failure("field " + std::string(field_.name) + " has a type that this program does not know");
  }
}

template <typename T>
void FieldStatistics::add_values(const mimo::Block& block) {
  const auto values = block.view<T>(field_);
  if (values.size() == 0) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  min_ = std::min(min_, static_cast<double>(*low));
  max_ = std::max(max_, static_cast<double>(*high));
  sum_ += std::accumulate(values.begin(), values.end(), 0.0);
  count_ += values.size();
}

std::vector<std::int32_t> infants(const mimo::Env& env) {
  const std::string root = "mimo_location";
  std::vector<std::int32_t> bodies;
  for (const std::int32_t body : env.ids(MIMO_BODY)) {
    const std::string called = env.name(MIMO_BODY, body);
    const bool is_root = called.size() >= root.size() && called.substr(called.size() - root.size()) == root;
    if (is_root) bodies.push_back(body);
  }
  return bodies;
}

std::string prefix(const mimo_agent_info& agent) { return *agent.name == '\0' ? "" : agent.name + std::string("/"); }

std::size_t touch_sensors(const mimo::Env& env) {
  std::size_t sum = 0;
  const auto fields = env.layout().fields();
  for (const mimo_agent_info& agent : env.agents()) {
    const std::string path = prefix(agent) + "touch/";
    const auto of_touch = [&](const mimo_field& field) { return std::string(field.name).find(path) == 0; };
    const auto first = std::find_if(fields.begin(), fields.end(), of_touch);
    if (first != fields.end()) sum += first->receptors;  // all fields of an agent's touch have the same
  }
  return sum;
}

std::string joint_label(const mimo::Env& env, std::int32_t joint) {
  const std::string name = env.name(MIMO_JOINT, joint);
  if (!name.empty()) return name;
  const bool free = env.width(MIMO_JOINT_POSITION, {joint}) == 7;
  const std::string body = env.name(MIMO_BODY, env.body_of(MIMO_JOINT, joint));
  return free && !body.empty() ? "free:" + body : "joint:" + std::to_string(joint);
}

const char* dtype_name(const mimo_field& field) {
  switch (field.dtype) {
    case MIMO_U8: return "uint8";
    case MIMO_I32: return "int32";
    case MIMO_F32: return "float32";
    case MIMO_F64: return "float64";
    default: return "unknown";
  }
}

std::vector<std::size_t> shape(const mimo_field& field) { return {field.shape, field.shape + field.ndim}; }

std::string shape_text(const mimo_field& field) {
  std::string text;
  for (std::size_t extent : shape(field)) text += (text.empty() ? "" : "x") + std::to_string(extent);
  return text;
}

std::string or_dash(const std::string& text) { return text.empty() ? "-" : text; }

}  // namespace cli
