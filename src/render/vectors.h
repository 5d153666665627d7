// Products of vectors, summed from the first number to the last: Eigen sums the last two first, and pictures would then
// differ in a last digit here and there.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace mimo::render {

inline double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Eigen::Vector3d unit(const Eigen::Vector3d& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? Eigen::Vector3d(a / length) : Eigen::Vector3d(0, 0, 1);
}

// A vector as a frame sees it whose axes are these columns.
inline Eigen::Vector3d seen_from(const Eigen::Matrix3d& axes, const Eigen::Vector3d& v) {
  return {dot(axes.col(0), v), dot(axes.col(1), v), dot(axes.col(2), v)};
}

}  // namespace mimo::render
