// Turns head and eyes to a point, as the original does: the joints are set, not driven.
#pragma once

#include <Eigen/Core>
#include <array>

#include "body/body.h"

namespace mimo::tasks {

class Tracking {
 public:
  Tracking(const mjModel& model, const body::Body& body);

  // From where the head is; angles beyond a joint's range are cut to it.
  void look_at(const Eigen::Vector3d& point, engine::Physics& physics) const;
  // Addresses in qpos of the joints that it sets.
  Span<const int> joints() const { return addresses_; }

 private:
  int head_;
  Eigen::Vector3d left_eye_;  // in the head's frame
  std::array<body::Joint, 9> joints_;
  std::array<int, 9> addresses_;
};

}  // namespace mimo::tasks
