#include "actuation/joint_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fail.h"
#include "body/body.h"

namespace mimo::actuation {
namespace {

struct Bounds {
  double low, high;
};

// An infant's motors are weaker to one side, which their force ranges say. What the controls of anything else mean is
// its author's business: they go as far as he allows.
Bounds bounds_of(const mjModel& model, const body::Body& body, int actuator) {
  const double* range = (body.infant ? model.actuator_forcerange : model.actuator_ctrlrange) + 2 * actuator;
  if (body.infant || model.actuator_ctrllimited[actuator] != 0) return {range[0], range[1]};
  const double endless = std::numeric_limits<double>::infinity();
  return {-endless, endless};
}

using engine::Kind;

std::vector<body::Motor> motors_with_locks(const mjModel& model, const body::Body& body) {
  std::vector<body::Motor> motors = body::motors(model, body);
  for (const body::Motor& motor : motors) {
    if (motor.lock >= 0) continue;
    fail(Status::kUnsupported,
         "position control: joint {} of {} has no equality constraint in the model that could hold it",
         engine::name(model, Kind::kJoint, motor.joint.id), engine::name(model, Kind::kActuator, motor.id));
  }
  return motors;
}

}  // namespace

Torque::Torque(const mjModel& model, const body::Body& body, bool normalize)
    : Actuation(normalize), actuators_(body.actuators) {
  for (const int id : actuators_) {
    const Bounds bounds = bounds_of(model, body, id);
    const char* name = engine::name(model, engine::Kind::kActuator, id);
    require(!normalize || std::isfinite(bounds.high), "normalize_actions is 1, but actuator \"{}\" has no ctrlrange",
            name);
    add(name, bounds.low, bounds.high);
  }
}

void Torque::command(std::size_t index, double value, engine::Physics& physics) {
  physics.data().ctrl[actuators_[index]] = value;
}

double Torque::commanded(std::size_t index, const engine::Physics& physics) const {
  return physics.data().ctrl[actuators_[index]];
}

void Torque::pull(std::size_t motor, double share, double* offsets) const {
  offsets[motor] += share * std::abs(share > 0 ? range(motor).high : range(motor).low);
}

// What an infant's motors are told is known as torque as well; the actuators of others may be servos or muscles.
Feedback Torque::feel(const mjModel& model, const body::Body& body) const {
  const std::vector<int>& ids = body.actuators;
  Feedback feedback;
  feedback.commands.push_back(
      {actuator_field(model, ids, "control"), [ids](const mjModel&, const mjData& data, float* out) {
         for (const int id : ids) *out++ = static_cast<float>(data.ctrl[id]);
       }});
  if (body.infant) {
    observation::Field field = actuator_field(model, ids, "motor_torque");
    field.unit = "Nm";
    field.frame = "joint";
    feedback.commands.push_back({field, [ids](const mjModel& now, const mjData& data, float* out) {
                                   for (const int id : ids) {
                                     *out++ = static_cast<float>(now.actuator_gear[6 * id] * data.ctrl[id]);
                                   }
                                 }});
  } else {
    observation::Field field = actuator_field(model, ids, "actuator_force");
    field.unit = "N or Nm";
    field.time = observation::Time::kLastStart;
    feedback.commands.push_back({field, [ids](const mjModel&, const mjData& data, float* out) {
                                   for (const int id : ids) *out++ = static_cast<float>(data.actuator_force[id]);
                                 }});
  }
  return feedback;
}

double Torque::effort(const mjModel& model, const mjData& data) const {
  double spent = 0, most = 0;
  for (const int id : actuators_) {
    const double strength = std::abs(model.actuator_gear[6 * id]);
    spent += data.ctrl[id] * data.ctrl[id] * strength;
    most += strength;
  }
  return most > 0 ? spent / (static_cast<double>(commands()) * most) : 0;
}

Position::Position(const mjModel& model, const body::Body& body, bool normalize)
    : Actuation(normalize), motors_(motors_with_locks(model, body)), by_lock_(static_cast<std::size_t>(model.neq), -1) {
  for (const body::Motor& motor : motors_) {
    const char* name = engine::name(model, Kind::kActuator, motor.id);
    if (!std::isfinite(motor.joint.low)) {
      fail(Status::kUnsupported, "position control: joint {} of {} has no range",
           engine::name(model, Kind::kJoint, motor.joint.id), name);
    }
    const auto [weakest, strongest] = body::forces_of(model, motor.id);
    const double gear = model.actuator_gear[6 * motor.id];
    by_lock_[static_cast<std::size_t>(motor.lock)] = static_cast<int>(strengths_.size());
    strengths_.push_back({std::min(gear * weakest, gear * strongest), std::max(gear * weakest, gear * strongest)});
    add(name, motor.joint.low, motor.joint.high, body::units_of(model, {motor.joint}).position);
  }
}

void Position::reset(engine::Physics& physics) {
  for (const body::Motor& motor : motors_) physics.hold(motor.lock, physics.start()[motor.joint.qpos]);
}

bool Position::holds(int lock) const {
  return std::any_of(motors_.begin(), motors_.end(), [=](const body::Motor& motor) { return motor.lock == lock; });
}

// A lock's row of the constraints is the joint itself, so that its force is a torque about it.
bool Position::pulls(const mjData& data, double* shares) const {
  const std::size_t count = motors_.size();
  std::fill(shares, shares + 2 * count, 0.0);
  for (int row = 0; row < data.ne; ++row) {
    const int motor = by_lock_[static_cast<std::size_t>(data.efc_id[row])];
    if (motor < 0) continue;
    const auto at = static_cast<std::size_t>(motor);
    const double torque = data.efc_force[row];
    const Strength& strength = strengths_[at];
    if (torque < 0 && strength.negative < 0) shares[at] = torque / strength.negative;
    if (torque > 0 && strength.positive > 0) shares[count + at] = torque / strength.positive;
  }
  return true;
}

Feedback Position::feel(const mjModel& model, const body::Body& body) const {
  std::vector<int> locks;
  for (const body::Motor& motor : motors_with_locks(model, body)) locks.push_back(motor.lock);
  observation::Field field = actuator_field(model, body.actuators, "target");
  field.unit = body::units_of(model, body.joints).position;
  field.frame = "joint";
  Feedback feedback;
  feedback.commands.push_back({field, [locks](const mjModel& now, const mjData&, float* out) {
                                 for (const int lock : locks) {
                                   *out++ = static_cast<float>(engine::lock_angle(now, lock));
                                 }
                               }});
  return feedback;
}

void Position::command(std::size_t index, double value, engine::Physics& physics) {
  physics.hold(motors_[index].lock, value);
}

double Position::commanded(std::size_t index, const engine::Physics& physics) const {
  return engine::lock_angle(physics.model(), motors_[index].lock);
}

void Position::pull(std::size_t motor, double share, double* offsets) const {
  offsets[motor] += share * (range(motor).high - range(motor).low);
}

}  // namespace mimo::actuation
