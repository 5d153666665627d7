#include "api.h"

#include <cstdio>
#include <numeric>

namespace cli {

void check(mimo_status status) {
  if (status != MIMO_OK) throw MimoError(status, mimo_last_error());
}

void print_message(void*, std::int32_t level, const char* message) {
  std::fprintf(stderr, "mimo: %s: %s\n", level == MIMO_LOG_WARNING ? "warning" : "note", message);
}

const char* Field::dtype_name() const {
  switch (dtype) {
    case MIMO_U8: return "uint8";
    case MIMO_I32: return "int32";
    case MIMO_F32: return "float32";
    case MIMO_F64: return "float64";
    default: return "unknown";
  }
}

const char* Field::time_name() const { return time == MIMO_AT_END ? "end" : "last_start"; }

std::string Field::shape_text() const {
  std::string text;
  for (std::size_t extent : shape) text += (text.empty() ? "" : "x") + std::to_string(extent);
  return text;
}

Scene::Scene(const mimo_scene_config& config) : handle_(nullptr, mimo_scene_destroy) {
  mimo_scene* scene = nullptr;
  check(mimo_scene_create(&config, &scene));
  handle_.reset(scene);
}

Env::Env(const Scene& scene, const mimo_env_config& config) : handle_(nullptr, mimo_env_destroy) {
  mimo_env* env = nullptr;
  check(mimo_env_create(scene.get(), &config, &env));
  handle_.reset(env);
}

void Env::reset(std::uint64_t seed, Block& block) { check(mimo_env_reset(get(), &seed, block.data(), block.bytes())); }

void Env::step(const std::vector<float>& action, Block& block) {
  const float* values = action.empty() ? nullptr : action.data();
  check(mimo_env_step(get(), values, action.size(), block.data(), block.bytes(), nullptr, nullptr, nullptr, 0));
}

std::uint32_t Env::frame_skip() const {
  std::uint32_t count = 0;
  check(mimo_env_frame_skip(get(), &count));
  return count;
}

std::string Env::task() const {
  const char* name = "";
  check(mimo_env_task(get(), &name));
  return name;
}

double Env::timestep() const {
  double seconds = 0;
  check(mimo_env_timestep(get(), &seconds));
  return seconds;
}

Block Env::make_block() const {
  std::size_t bytes = 0;
  check(mimo_env_observation_size(get(), &bytes, nullptr));
  return Block(bytes);
}

std::vector<Field> Env::fields() const {
  std::size_t count = 0;
  check(mimo_env_observation_size(get(), nullptr, &count));
  std::vector<Field> fields;
  for (std::size_t i = 0; i < count; ++i) {
    mimo_field f{};
    f.struct_size = sizeof f;
    check(mimo_env_observation_field(get(), i, &f));
    fields.push_back({f.name, f.unit, f.frame, f.dtype, f.time, f.offset, f.bytes,
                      std::vector<std::size_t>(f.shape, f.shape + f.ndim), f.low, f.high});
  }
  return fields;
}

std::vector<std::string> Env::action_names() const {
  std::size_t count = 0;
  check(mimo_env_action_size(get(), &count));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    const char* name = nullptr;
    check(mimo_env_action_name(get(), i, &name));
    names.emplace_back(name);
  }
  return names;
}

std::pair<std::vector<float>, std::vector<float>> Env::action_bounds() const {
  std::size_t count = 0;
  check(mimo_env_action_size(get(), &count));
  std::vector<float> low(count), high(count);
  if (count != 0) check(mimo_env_action_bounds(get(), low.data(), high.data(), count));
  return {low, high};
}

std::vector<mimo_agent_info> Env::agents() const {
  std::size_t count = 0;
  check(mimo_env_agent_count(get(), &count));
  std::vector<mimo_agent_info> agents(count);
  for (std::size_t i = 0; i < count; ++i) {
    agents[i].struct_size = sizeof agents[i];
    check(mimo_env_agent(get(), i, &agents[i]));
  }
  return agents;
}

std::size_t Env::touch_sensors() const {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < agents().size(); ++i) {
    std::size_t count = 0;
    check(mimo_env_touch_sensors(get(), i, nullptr, nullptr, nullptr, nullptr, 0, &count));
    sum += count;
  }
  return sum;
}

std::size_t Env::count(std::int32_t kind) const {
  std::size_t count = 0;
  check(mimo_env_count(get(), kind, &count));
  return count;
}

std::vector<std::int32_t> Env::ids(std::int32_t kind) const {
  std::vector<std::int32_t> ids(count(kind));
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

std::int32_t Env::find(std::int32_t kind, const std::string& name) const {
  std::int32_t id = 0;
  check(mimo_env_find(get(), kind, name.c_str(), &id));
  return id;
}

std::vector<std::int32_t> Env::infants() const {
  const std::string root = "mimo_location";
  std::vector<std::int32_t> bodies;
  for (const std::int32_t body : ids(MIMO_BODY)) {
    const std::string called = name(MIMO_BODY, body);
    const bool is_root = called.size() >= root.size() && called.substr(called.size() - root.size()) == root;
    if (is_root) bodies.push_back(body);
  }
  return bodies;
}

std::string Env::name(std::int32_t kind, std::int32_t id) const {
  const char* name = nullptr;
  check(mimo_env_name(get(), kind, id, &name));
  return name;
}

std::int32_t Env::body_of(std::int32_t kind, std::int32_t id) const {
  std::int32_t body = 0;
  check(mimo_env_body_of(get(), kind, id, &body));
  return body;
}

std::size_t Env::width(std::int32_t quantity, const std::vector<std::int32_t>& ids) const {
  std::size_t width = 0;
  if (!ids.empty()) check(mimo_env_width(get(), quantity, ids.data(), ids.size(), &width));
  return width;
}

std::vector<double> Env::get(std::int32_t quantity, const std::vector<std::int32_t>& ids) const {
  std::vector<double> values(width(quantity, ids));
  if (!ids.empty()) check(mimo_env_get(get(), quantity, ids.data(), ids.size(), values.data(), values.size()));
  return values;
}

void Env::set(std::int32_t quantity, const std::vector<std::int32_t>& ids, const std::vector<double>& values) {
  if (!ids.empty()) check(mimo_env_set(get(), quantity, ids.data(), ids.size(), values.data(), values.size()));
}

}  // namespace cli
