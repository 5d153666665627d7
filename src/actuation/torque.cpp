#include "actuation/torque.h"

namespace mimo::actuation {

Torque::Torque(const mjModel& model, const body::Body& body, bool normalize)
    : Actuation(normalize), actuators_(body.actuators) {
  for (const int id : actuators_) {
    const double* range = model.actuator_forcerange + 2 * id;
    add(engine::name(model, engine::Kind::kActuator, id), range[0], range[1]);
  }
}

void Torque::command(std::size_t index, double value, engine::Physics& physics) const {
  physics.data().ctrl[actuators_[index]] = value;
}

}  // namespace mimo::actuation
