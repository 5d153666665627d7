// Positions and orientations of configs.
#pragma once

#include <algorithm>

#include "capi/check.h"
#include "document/pose.h"

namespace mimo::capi {

// Checked: finite, and a quaternion that is not zero.
inline document::Pose pose(const double (&position)[3], const double (&orientation)[4]) {
  check_finite(position, 3, "position");
  check_finite(orientation, 4, "orientation");
  const double square = orientation[0] * orientation[0] + orientation[1] * orientation[1] +
                        orientation[2] * orientation[2] + orientation[3] * orientation[3];
  require(square > 1e-18, "orientation is zero, expected a quaternion w x y z");
  document::Pose result;
  std::copy(std::begin(position), std::end(position), result.position.begin());
  std::copy(std::begin(orientation), std::end(orientation), result.orientation.begin());
  return result;
}

}  // namespace mimo::capi
