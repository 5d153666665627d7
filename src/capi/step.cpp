// Stepping and observations.
#include <mujoco/mujoco.h>

#include <Eigen/Core>

#include "capi/block.h"
#include "capi/check.h"
#include "capi/growth.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/reset.h"
#include "capi/results.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

void check_actions(const env::World& world, Span<const float> actions) {
  require(actions.empty() || actions.size() == world.action_size(), "action_count is {}, expected {} or 0",
          actions.size(), world.action_size());
  world.check_actions(actions);
}

// Of all physics steps of a step.
std::size_t degrees(const env::World& world) {
  return static_cast<std::size_t>(world.frame_skip()) * static_cast<std::size_t>(world.model().nv);
}

bool has_length(const double* quaternion) {
  return Eigen::Map<const Eigen::Vector4d>(quaternion).squaredNorm() > 1e-20;
}

// Numbers among the positions of one moment at which a quaternion starts.
template <typename Visit>
void each_quaternion(const mjModel& model, Visit&& visit) {
  for (int joint = 0; joint < model.njnt; ++joint) {
    if (model.jnt_type[joint] == mjJNT_FREE) visit(model.jnt_qposadr[joint] + 3);
    if (model.jnt_type[joint] == mjJNT_BALL) visit(model.jnt_qposadr[joint]);
  }
}

void check_movement(const env::World& world, const mimo_movement& movement) {
  check_reserved(movement.reserved, "movement: reserved");
  const auto moments = static_cast<std::size_t>(world.frame_skip()), nq = static_cast<std::size_t>(world.model().nq);
  require(movement.positions != nullptr, "movement: positions is NULL");
  require(movement.position_count == moments * nq,
          "movement: position_count is {}, expected {}: {} for each of {} physics steps", movement.position_count,
          moments * nq, nq, moments);
  check_finite(movement.positions, movement.position_count, "movement: positions");
  check_buffer(movement.forces, movement.force_count, degrees(world), "movement: forces");
  for (std::size_t i = 0; i < moments; ++i) {
    each_quaternion(world.model(), [&](int at) {
      const std::size_t first = i * nq + static_cast<std::size_t>(at);
      require(has_length(movement.positions + first),
              "movement: positions[{}] is the first of a quaternion of length 0", first);
    });
  }
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
    object.reset(ages, seed.pointer(), block_of(object.world().layout(), block, block_bytes));
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
    check_movement(world, ours);
    const std::size_t forces = ours.forces == nullptr ? 0 : degrees(world);
    world.follow({ours.positions, ours.position_count}, {ours.forces, forces},
                 block_of(world.layout(), block, block_bytes));
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
