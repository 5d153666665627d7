// Positions of bodies as Eigen sees them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/physics.h"

namespace mimo::tasks {

inline Eigen::Vector3d position(const engine::Physics& physics, int body) {
  return Eigen::Map<const Eigen::Vector3d>(physics.data().xpos + 3 * body);
}

// The middle of the origins of some bodies, at least one.
inline Eigen::Vector3d center(const engine::Physics& physics, const std::vector<int>& bodies) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int body : bodies) sum += position(physics, body);
  return sum / static_cast<double>(bodies.size());
}

}  // namespace mimo::tasks
