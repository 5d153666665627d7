// Stepping and observations.
#include "capi/block.h"
#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"

namespace mimo::capi {
namespace {

void check_actions(const env::World& world, Span<const float> actions) {
  require(actions.empty() || actions.size() == world.action_size(), "action_count is {}, expected {} or 0",
          actions.size(), world.action_size());
  world.check_actions(actions);
}

// None where the caller wants none.
template <typename T>
Span<T> optional(T* values, std::size_t count) {
  return values == nullptr ? Span<T>() : Span<T>(values, count);
}

void check_agents(const env::World& world, std::size_t agents, bool any) {
  check_length<double>(agents, "agents");
  const std::size_t expected = any ? world.agents().size() : 0;
  if (any && agents < expected) {
    fail(Status::kBufferTooSmall, "agents is {}, but reward, terminated and truncated need {}", agents, expected);
  }
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_reset(mimo_env* env, const uint64_t* seed, void* block, size_t block_bytes) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world;
    world.reset(seed, block_of(world.layout(), block, block_bytes));
  });
}

mimo_status mimo_env_step(mimo_env* env, const float* action, size_t action_count, void* block, size_t block_bytes,
                          double* reward, uint8_t* terminated, uint8_t* truncated, size_t agents) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world;
    const Span<const float> actions = array(action, action_count, "action");
    check_actions(world, actions);
    check_agents(world, agents, reward != nullptr || terminated != nullptr || truncated != nullptr);
    std::uint8_t* start = block_of(world.layout(), block, block_bytes);
    const std::size_t count = world.agents().size();
    world.step(actions, start, {optional(reward, count), optional(terminated, count), optional(truncated, count)});
  });
}

mimo_status mimo_env_observe(mimo_env* env, void* block, size_t block_bytes) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world;
    require(block != nullptr, "block is NULL");
    world.observe(block_of(world.layout(), block, block_bytes));
  });
}

mimo_status mimo_env_physics_step(mimo_env* env, size_t count) noexcept {
  return guard(env, [&] {
    require(count <= 1000000, "count is {}, expected up to 1000000", count);
    open(env).world.step_physics(static_cast<int>(count));
  });
}

mimo_status mimo_env_time(const mimo_env* env, double* seconds) noexcept {
  return guard(env, [&] { out(seconds, "seconds") = open(env).world.data().time; });
}

mimo_status mimo_env_timestep(const mimo_env* env, double* seconds) noexcept {
  return guard(env, [&] { out(seconds, "seconds") = open(env).world.model().opt.timestep; });
}

}  // extern "C"
