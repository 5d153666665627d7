// An action is a motor's share of its largest torque; the joints' springs and dampers stand for tissue.
#pragma once

#include "actuation/actuation.h"

namespace mimo::actuation {

class Torque : public Actuation {
 public:
  // Ranges are the motors' force ranges: a motor may be weaker to one side.
  Torque(const mjModel& model, const body::Body& body, bool normalize);
  void pull(std::size_t motor, double share, double* offsets) const override;
  double effort(const mjModel& model, const mjData& data) const override;

 private:
  Feedback feel(const mjModel& model, const body::Body& body) const override;
  void command(std::size_t index, double value, engine::Physics& physics) override;
  double commanded(std::size_t index, const engine::Physics& physics) const override;

  std::vector<int> actuators_;
};

}  // namespace mimo::actuation
