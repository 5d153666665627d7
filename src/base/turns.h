// Products and lengths of Eigen's quaternions in one order of rounding. Eigen's own have another order with vectors of
// the processor, which it uses on x86-64 and not elsewhere (cmake/MimoOptions.cmake). That of x86-64 is taken here.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace mimo {

// First b, then a: a * b.
inline Eigen::Quaterniond turn_after(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return {(a.w() * b.w() - a.y() * b.y()) - (a.z() * b.z() + a.x() * b.x()),
          (a.w() * b.x() + a.y() * b.z()) - (a.z() * b.y() - a.x() * b.w()),
          (a.w() * b.y() + a.y() * b.w()) + (a.z() * b.x() - a.x() * b.z()),
          (a.w() * b.z() - a.y() * b.x()) + (a.z() * b.w() + a.x() * b.y())};
}

// Of length 1, except for 0.
inline Eigen::Quaterniond normal_turn(const Eigen::Quaterniond& q) {
  const double square = (q.x() * q.x() + q.z() * q.z()) + (q.y() * q.y() + q.w() * q.w());
  if (!(square > 0)) return q;
  const double length = std::sqrt(square);
  return {q.w() / length, q.x() / length, q.y() / length, q.z() / length};
}

}  // namespace mimo
