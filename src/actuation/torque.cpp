#include "actuation/torque.h"

#include <cmath>
#include <limits>

#include "base/fail.h"

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

}  // namespace mimo::actuation
