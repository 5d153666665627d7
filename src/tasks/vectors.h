// Positions of bodies as Eigen sees them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/physics.h"

namespace mimo::tasks {

inline Eigen::Vector3d position(const mjData& data, int body) {
  return Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * body);
}
inline Eigen::Vector3d position(const engine::Physics& physics, int body) { return position(physics.data(), body); }

// The middle of the origins of some bodies, at least one.
inline Eigen::Vector3d center(const mjData& data, const std::vector<int>& bodies) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int body : bodies) sum += position(data, body);
  return sum / static_cast<double>(bodies.size());
}
inline Eigen::Vector3d center(const engine::Physics& physics, const std::vector<int>& bodies) {
  return center(physics.data(), bodies);
}

inline void put(const Eigen::Vector3d& vector, double* out) { Eigen::Map<Eigen::Vector3d>{out} = vector; }

}  // namespace mimo::tasks
