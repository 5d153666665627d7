#include <algorithm>

#include "actuation/actuation.h"

namespace mimo::actuation {

Torque::Torque(const mjModel& model, const body::Body& body) : actuators_(body.actuators) {
  for (const int id : actuators_) {
    low_.push_back(static_cast<float>(model.actuator_forcerange[2 * id]));
    high_.push_back(static_cast<float>(model.actuator_forcerange[2 * id + 1]));
    names_.emplace_back(engine::name(model, engine::Kind::kActuator, id));
  }
}

void Torque::apply(Span<const float> actions, mjData& data) const {
  for (std::size_t i = 0; i < actuators_.size(); ++i) {
    data.ctrl[actuators_[i]] = static_cast<double>(std::clamp(actions[i], low_[i], high_[i]));
  }
}

}  // namespace mimo::actuation
