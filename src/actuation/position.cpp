#include "actuation/position.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"

namespace mimo::actuation {

using engine::Kind;

Position::Position(const mjModel& model, const body::Body& body, bool normalize)
    : Actuation(normalize), motors_(body::motors(model, body)) {
  for (const body::Motor& motor : motors_) {
    const char* name = engine::name(model, Kind::kActuator, motor.id);
    if (motor.lock < 0) {
      fail(Status::kUnsupported, "position control: joint {} of {} has no equality that could hold it",
           engine::name(model, Kind::kJoint, motor.joint.id), name);
    }
    if (!std::isfinite(motor.joint.low)) {
      fail(Status::kUnsupported, "position control: joint {} of {} has no range",
           engine::name(model, Kind::kJoint, motor.joint.id), name);
    }
    add(name, motor.joint.low, motor.joint.high);
  }
}

void Position::reset(engine::Physics& physics) {
  for (const body::Motor& motor : motors_) physics.hold(motor.lock, physics.start()[motor.joint.qpos]);
}

bool Position::holds(int lock) const {
  return std::any_of(motors_.begin(), motors_.end(), [=](const body::Motor& motor) { return motor.lock == lock; });
}

void Position::command(std::size_t index, double value, engine::Physics& physics) {
  physics.hold(motors_[index].lock, value);
}

}  // namespace mimo::actuation
