#include "motion/rotation.h"

#include <cmath>

#include "programs/angles.h"

namespace cli {

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
  const double sine = rotation.vec().norm();
  const double angle = 2 * std::atan2(sine, rotation.w());
  return (sine < 1e-12 ? 2 : (angle > kPi ? angle - 2 * kPi : angle) / sine) * rotation.vec();
}

}  // namespace cli
