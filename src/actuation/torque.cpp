#include "actuation/torque.h"

#include <cmath>

namespace mimo::actuation {

Torque::Torque(const mjModel& model, const body::Body& body, bool normalize)
    : Actuation(normalize), actuators_(body.actuators) {
  for (const int id : actuators_) {
    const double* range = model.actuator_forcerange + 2 * id;
    add(engine::name(model, engine::Kind::kActuator, id), range[0], range[1]);
  }
}

void Torque::command(std::size_t index, double value, engine::Physics& physics) {
  physics.data().ctrl[actuators_[index]] = value;
}

double Torque::effort(const mjModel& model, const mjData& data) const {
  double spent = 0, most = 0;
  for (const int id : actuators_) {
    const double strength = std::abs(model.actuator_gear[6 * id]);
    spent += data.ctrl[id] * data.ctrl[id] * strength;
    most += strength;
  }
  return most > 0 ? spent / (static_cast<double>(size()) * most) : 0;
}

}  // namespace mimo::actuation
