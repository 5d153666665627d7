// A little vector algebra in double precision: what prepares a frame.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "render/surfaces.h"

namespace mimo::rays {

using Vec = Eigen::Vector3d;
using render::dot;
using render::seen_from;
using render::unit;

// Nothing that is drawn is farther away or larger, m: of such numbers, squares and products still fit floats.
constexpr double kFarthest = 1e12;
inline bool is_near(double v) { return std::abs(v) < kFarthest; }  // false of what is no number

inline std::array<float, 3> narrow(const Vec& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
inline std::array<float, 3> three(const float* v) { return {v[0], v[1], v[2]}; }

}  // namespace mimo::rays
