// Stepping and observations.

#include "capi/check.h"
#include "capi/configs.h"
#include "capi/objects.h"
#include "capi/results.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

void check_actions(const env::World& world, Span<const float> actions) {
  require(actions.empty() || actions.size() == world.action_size(), "action_count is {}, expected {} or 0",
          actions.size(), world.action_size());
  world.check_actions(actions);
}

// Room for the forces of a movement; none where the caller wants none.
Span<double> forces_of(const env::World& world, const mimo_movement& movement) {
  const auto needed = static_cast<std::size_t>(world.frame_skip()) * static_cast<std::size_t>(world.model().nv);
  check_buffer(movement.forces, movement.force_count, needed, "movement: forces");
  return optional(movement.forces, needed);
}

}  // namespace

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_reset(mimo_env* env, const mimo_reset_config* config, void* block, size_t block_bytes) noexcept {
  return guard(env, [&] {
    EnvObject& object = open(env);
    const mimo_reset_config ours = read_struct(config, mimo_reset_config{}, "config");
    const Seed seed = seed_of(ours);
    const blueprint::Ages ages = ages_from(ours.growth, ours.growth_count, "growth");
    object.aging().reset(ages, seed.pointer(), block_of(object.world().layout(), block, block_bytes));
  });
}

mimo_status mimo_env_step(mimo_env* env, const float* action, size_t action_count, void* block, size_t block_bytes,
                          const mimo_env_results* results) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world();
    const Span<const float> actions = array(action, action_count, "action");
    check_actions(world, actions);
    const env::Results to = results_of(world, results);
    world.step(actions, block_of(world.layout(), block, block_bytes), to);
  });
}

mimo_status mimo_env_follow(mimo_env* env, const mimo_movement* movement, void* block, size_t block_bytes) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world();
    require(movement != nullptr, "movement is NULL");
    const mimo_movement ours = read_struct(movement, "movement");
    check_reserved(ours.reserved, "movement: reserved");
    require(ours.positions != nullptr, "movement: positions is NULL");
    const Span<const double> positions(ours.positions, ours.position_count);
    world.check_movement(positions);
    const Span<double> forces = forces_of(world, ours);
    world.follow(positions, forces, block_of(world.layout(), block, block_bytes));
  });
}

mimo_status mimo_env_observe(mimo_env* env, void* block, size_t block_bytes) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world();
    require(block != nullptr, "block is NULL");
    world.observe(block_of(world.layout(), block, block_bytes));
  });
}

mimo_status mimo_env_physics_step(mimo_env* env, size_t count) noexcept {
  return guard(env, [&] {
    require(count <= 1000000, "count is {}, expected up to 1000000", count);
    open(env).world().step_physics(static_cast<int>(count));
  });
}

mimo_status mimo_env_time(const mimo_env* env, double* seconds) noexcept {
  return guard(env, [&] { out(seconds, "seconds") = open(env).world().data().time; });
}

mimo_status mimo_env_timestep(const mimo_env* env, double* seconds) noexcept {
  return guard(env, [&] { out(seconds, "seconds") = open(env).world().model().opt.timestep; });
}

}  // extern "C"

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_timing(const mimo_env* env, mimo_timing* timing) noexcept {
  return guard(env, [&] {
    const env::Timing& inner = open(env).world().timing();
    mimo_timing ours{};
    ours.steps = inner.steps;
    ours.total = inner.total;
    ours.physics = inner.physics;
    for (const auto& [share, seconds] : header::kTimes) ours.*seconds = inner.senses[static_cast<std::size_t>(share)];
    write_described(timing, ours, "timing");
  });
}

mimo_status mimo_env_timing_reset(mimo_env* env) noexcept {
  return guard(env, [&] { open(env).world().reset_timing(); });
}

}  // extern "C"

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_env_state_size(const mimo_env* env, size_t* bytes) noexcept {
  return guard(env, [&] { out(bytes, "bytes") = open(env).world().state_bytes(); });
}

mimo_status mimo_env_state_save(const mimo_env* env, void* state, size_t state_bytes) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    auto* start = static_cast<std::uint8_t*>(state);
    require(start != nullptr, "state is NULL");
    check_buffer(start, state_bytes, world.state_bytes(), "state");
    world.save({start, world.state_bytes()});
  });
}

mimo_status mimo_env_state_load(mimo_env* env, const void* state, size_t state_bytes,
                                mimo_load_report* report) noexcept {
  return guard(env, [&] {
    EnvObject& object = open(env);
    const auto* start = static_cast<const std::uint8_t*>(state);
    require(start != nullptr, "state is NULL");
    load_and_report(report, object.loaded, [&] { return object.world().load({start, state_bytes}); });
  });
}

}  // extern "C"
