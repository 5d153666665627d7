// Rotations as an axis times its angle, rad.
#pragma once

#include <Eigen/Geometry>

namespace cli {

// The shorter way round; by the sine where angles are small, as the cosine of those tells nothing.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation);

}  // namespace cli
