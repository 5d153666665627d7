// Positions of bodies as Eigen sees them.
#pragma once

#include <Eigen/Core>

#include "engine/physics.h"

namespace mimo::tasks {

inline Eigen::Vector3d position(const engine::Physics& physics, int body) {
  return Eigen::Map<const Eigen::Vector3d>(physics.data().xpos + 3 * body);
}

}  // namespace mimo::tasks
