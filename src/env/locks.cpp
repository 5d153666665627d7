#include "env/locks.h"

#include <cmath>

#include "base/fail.h"

namespace mimo::env {
namespace {

int lock_of(const mjModel& model, int joint) {
  require(joint >= 0 && joint < model.njnt, "joint is {}, expected 0 to {}", joint, model.njnt - 1);
  const int lock = engine::find_lock(model, joint);
  if (lock < 0) {
    fail(Status::kUnsupported, "joint {} (\"{}\") has no equality that could hold it", joint,
         engine::name(model, engine::Kind::kJoint, joint));
  }
  return lock;
}

int free_lock_of(const World& world, int joint) {
  const int lock = lock_of(world.model(), joint);
  for (const Agent& agent : world.agents()) {
    if (!agent.actuation->holds(lock)) continue;
    fail(Status::kUnsupported, "joint {} (\"{}\") is under position control: its actions hold it", joint,
         engine::name(world.model(), engine::Kind::kJoint, joint));
  }
  return lock;
}

}  // namespace

Lock lock_state(const World& world, int joint) {
  const mjModel& model = world.model();
  const int lock = lock_of(model, joint);
  return {model.eq_active[lock] != 0, engine::lock_angle(model, lock)};
}

void lock(World& world, int joint, double angle) {
  const int lock = free_lock_of(world, joint);
  const mjModel& model = world.model();
  require(std::isfinite(angle), "angle is {}, expected radians", angle);
  const double* range = model.jnt_range + 2 * joint;
  require(model.jnt_limited[joint] == 0 || (angle >= range[0] && angle <= range[1]),
          "angle is {}, expected {} to {} for joint \"{}\"", angle, range[0], range[1],
          engine::name(model, engine::Kind::kJoint, joint));
  world.physics().hold(lock, angle);
}

void unlock(World& world, int joint) { world.physics().release(free_lock_of(world, joint)); }

}  // namespace mimo::env
