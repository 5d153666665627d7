/**
 * @file mimo/hpp/env.hpp
 * Environments: one simulated world with its agents' senses. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_ENV
#define MIMO_HPP_ENV

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "observation.hpp"
#include "results.hpp"
#include "scene.hpp"

namespace mimo {

namespace detail {
inline void destroy_env(mimo_env *env) { mimo_env_destroy(env); }
}  // namespace detail

class Env : public Handle<mimo_env, detail::destroy_env> {
 public:
  explicit Env(mimo_env *env) : Handle(env) {}
  explicit Env(const Scene &scene, const mimo_env_config &config = env_config()) : Handle(create(scene, config)) {}

  std::size_t agent_count() const {
    std::size_t count = 0;
    check(mimo_env_agent_count(get(), &count));
    return count;
  }
  std::size_t action_size() const {
    std::size_t count = 0;
    check(mimo_env_action_size(get(), &count));
    return count;
  }

  Block make_block() const { return detail::block_of<mimo_env>(get(), mimo_env_observation_size); }
  Results make_results() const {
    const std::size_t count = agent_count();
    return Results{std::vector<double>(count), std::vector<std::uint8_t>(count), std::vector<std::uint8_t>(count)};
  }
  std::vector<mimo_field> fields() const {
    return detail::fields_of<mimo_env>(get(), mimo_env_observation_size, mimo_env_observation_field);
  }
  /// The field of that name; throws std::out_of_range when there is none.
  mimo_field field(const std::string &name) const { return detail::field_named(fields(), name); }

  void reset(std::uint64_t seed, Block &block) { check(mimo_env_reset(get(), &seed, block.data(), block.bytes())); }
  void reset(Block &block) { check(mimo_env_reset(get(), nullptr, block.data(), block.bytes())); }
  void observe(Block &block) { check(mimo_env_observe(get(), block.data(), block.bytes())); }

  /// One step of all agents; an empty vector of actions leaves the controls as they are. Allocates nothing.
  void step(const std::vector<float> &actions, Block &block, Results &results) {
    const std::size_t agents = results.reward.size();
    if (results.terminated.size() != agents || results.truncated.size() != agents) {
      throw std::invalid_argument("vectors of the results differ in length");
    }
    check(mimo_env_step(get(), actions.empty() ? nullptr : actions.data(), actions.size(), block.data(), block.bytes(),
                        results.reward.data(), results.terminated.data(), results.truncated.data(), agents));
  }
  /// The same with results of its own.
  std::vector<Result> step(const std::vector<float> &actions, Block &block) {
    Results all = make_results();
    step(actions, block, all);
    std::vector<Result> results;
    for (std::size_t i = 0; i < all.reward.size(); ++i) {
      results.push_back(Result{all.reward[i], all.terminated[i] != 0, all.truncated[i] != 0});
    }
    return results;
  }

  double time() const {
    double seconds = 0;
    check(mimo_env_time(get(), &seconds));
    return seconds;
  }

  std::int32_t find(std::int32_t kind, const std::string &name) const {
    std::int32_t id = 0;
    check(mimo_env_find(get(), kind, name.c_str(), &id));
    return id;
  }
  std::vector<double> get_values(std::int32_t quantity, const std::vector<std::int32_t> &ids) const {
    std::size_t count = 0;
    check(mimo_env_width(get(), quantity, ids.data(), ids.size(), &count));
    std::vector<double> values(count);
    check(mimo_env_get(get(), quantity, ids.data(), ids.size(), values.data(), values.size()));
    return values;
  }
  void set_values(std::int32_t quantity, const std::vector<std::int32_t> &ids, const std::vector<double> &values) {
    check(mimo_env_set(get(), quantity, ids.data(), ids.size(), values.data(), values.size()));
  }

  std::string face(std::size_t agent = 0) const {
    const char *name = nullptr;
    check(mimo_env_face(get(), agent, &name));
    return name;
  }
  void set_face(const std::string &name, std::size_t agent = 0) {
    check(mimo_env_set_face(get(), agent, name.c_str()));
  }

  mimo_gaze gaze(std::size_t agent = 0) const {
    mimo_gaze gaze;
    gaze.struct_size = sizeof gaze;
    check(mimo_env_gaze(get(), agent, &gaze));
    return gaze;
  }
  /// Turns the eyes, and the head with MIMO_LOOK_HEAD, to a point at once.
  void look_at(double x, double y, double z, std::int32_t how = MIMO_LOOK_EYES, std::size_t agent = 0) {
    const double point[3] = {x, y, z};
    check(mimo_env_look_at(get(), agent, point, how, nullptr));
  }

  /// Holds a joint at an angle, softly, from the next step on.
  void lock(std::int32_t joint, double angle) { check(mimo_env_lock(get(), joint, angle)); }
  void unlock(std::int32_t joint) { check(mimo_env_unlock(get(), joint)); }
  void set_gravity(double x, double y, double z) { check(mimo_env_set_gravity(get(), x, y, z)); }

  /// Everything that the future depends on; a world that loads it goes on exactly so.
  std::vector<std::uint8_t> save() const {
    std::size_t bytes = 0;
    check(mimo_env_state_size(get(), &bytes));
    std::vector<std::uint8_t> state(bytes);
    check(mimo_env_state_save(get(), state.data(), state.size()));
    return state;
  }
  void load(const std::vector<std::uint8_t> &state) { check(mimo_env_state_load(get(), state.data(), state.size())); }
  /// Another world in the same state.
  Env clone() const {
    mimo_env *twin = nullptr;
    check(mimo_env_clone(get(), &twin));
    return Env(twin);
  }

 private:
  static mimo_env *create(const Scene &scene, const mimo_env_config &config) {
    mimo_env *env = nullptr;
    check(mimo_env_create(scene.get(), &config, &env));
    return env;
  }
};

/// The usual case: a built-in scene with its own infants.
inline Env make(const std::string &scene_name) {
  mimo_env *env = nullptr;
  check(mimo_env_make(scene_name.c_str(), &env));
  return Env(env);
}

}  // namespace mimo

#endif
