#include "facts.h"

namespace cli {

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

std::size_t touch_sensors(const mimo::Env& env) {
  std::size_t sum = 0;
  for (std::size_t agent = 0; agent < env.agent_count(); ++agent) sum += env.touch_sensor_count(agent);
  return sum;
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
