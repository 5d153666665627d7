// A thin C++ layer over mimo.h: handles that clean up after themselves, exceptions instead of status codes.
#pragma once

#include <mimo/mimo.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cli {

// A command cannot do what it was asked for; the text is the one line that the user gets.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The library refused a call.
class MimoError : public Failure {
 public:
  MimoError(mimo_status status, const std::string& message) : Failure(message), status_(status) {}
  mimo_status status() const { return status_; }

 private:
  mimo_status status_;
};

// Throws a MimoError with the library's own message unless the status is MIMO_OK.
void check(mimo_status status);

// A versioned struct with the library's defaults: defaults(mimo_env_config_init).
template <typename Config>
Config defaults(mimo_status (*init)(Config*, std::size_t)) {
  Config config;
  check(init(&config, sizeof config));
  return config;
}

// Prints the library's warnings on stderr; goes into the `log` member of configs.
void print_message(void* user, std::int32_t level, const char* message);

// One field of an observation block; strings and shape are copies.
struct Field {
  std::string name, unit, frame;
  std::int32_t dtype, time;
  std::size_t offset, bytes;
  std::vector<std::size_t> shape;
  double low, high;

  const char* dtype_name() const;
  const char* time_name() const;
  std::string shape_text() const;  // "256x256x3"
};

// Memory for observations, aligned as the library likes it.
class Block {
 public:
  explicit Block(std::size_t bytes) : lines_(bytes / sizeof(Line)) {}
  std::size_t bytes() const { return lines_.size() * sizeof(Line); }
  std::uint8_t* data() { return lines_.empty() ? nullptr : lines_.front().bytes; }
  const std::uint8_t* data() const { return lines_.empty() ? nullptr : lines_.front().bytes; }

 private:
  struct alignas(64) Line {
    std::uint8_t bytes[64];
  };
  std::vector<Line> lines_;
};

class Scene {
 public:
  explicit Scene(const mimo_scene_config& config);
  void add_agent(const mimo_agent_config& config) { check(mimo_scene_add_agent(get(), &config, nullptr)); }
  void add_agents(const mimo_agent_config& config) { check(mimo_scene_add_agents(get(), &config, nullptr)); }
  void set_touch(double spacing) { check(mimo_scene_set_touch(get(), 0, nullptr, spacing)); }
  mimo_scene* get() const { return handle_.get(); }

 private:
  std::unique_ptr<mimo_scene, void (*)(mimo_scene*)> handle_;
};

// A world. Ids and quantities are those of mimo.h.
class Env {
 public:
  Env(const Scene& scene, const mimo_env_config& config);
  mimo_env* get() const { return handle_.get(); }

  void reset(std::uint64_t seed, Block& block);
  void step(const std::vector<float>& action, Block& block);
  void physics_step(std::size_t count) { check(mimo_env_physics_step(get(), count)); }
  double timestep() const;
  std::uint32_t frame_skip() const;
  std::string task() const;

  Block make_block() const;
  std::vector<Field> fields() const;
  std::vector<std::string> action_names() const;
  std::pair<std::vector<float>, std::vector<float>> action_bounds() const;  // low, high
  std::vector<mimo_agent_info> agents() const;

  std::size_t touch_sensors() const;  // of all agents

  std::size_t count(std::int32_t kind) const;
  std::vector<std::int32_t> ids(std::int32_t kind) const;  // all of a kind
  std::int32_t find(std::int32_t kind, const std::string& name) const;
  std::vector<std::int32_t> infants() const;  // their root bodies, agents or not
  std::string name(std::int32_t kind, std::int32_t id) const;
  std::int32_t body_of(std::int32_t kind, std::int32_t id) const;

  std::size_t width(std::int32_t quantity, const std::vector<std::int32_t>& ids) const;
  std::vector<double> get(std::int32_t quantity, const std::vector<std::int32_t>& ids) const;
  void set(std::int32_t quantity, const std::vector<std::int32_t>& ids, const std::vector<double>& values);

 private:
  std::unique_ptr<mimo_env, void (*)(mimo_env*)> handle_;
};

}  // namespace cli
