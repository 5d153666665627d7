// Vectors in states.
#pragma once

#include <Eigen/Core>

#include "base/bytes.h"

namespace mimo::receptors {

inline void put(ByteWriter& to, const Eigen::Vector3d& vector) { to.put(Span<const double>(vector.data(), 3)); }

inline Eigen::Vector3d take(ByteReader& from, const char* what) {
  Eigen::Vector3d vector;
  for (double& number : vector) number = from.take_finite(what);
  return vector;
}

}  // namespace mimo::receptors
