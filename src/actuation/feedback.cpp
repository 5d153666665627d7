#include "actuation/feedback.h"

namespace mimo::actuation {

observation::Field actuator_field(const mjModel& model, const std::vector<int>& actuators, const char* name) {
  observation::Field field;
  field.name = std::string("proprioception/") + name;
  field.shape = {actuators.size()};
  field.frame = "actuator";
  field.time = observation::Time::kEnd;
  for (const int id : actuators) {
    field.labels.emplace_back(engine::name(model, engine::Kind::kActuator, id));
    field.bodies.push_back(body::moved_by(model, id));
  }
  return field;
}

}  // namespace mimo::actuation
