// A little vector algebra in double precision: what prepares a frame.
#pragma once

#include <array>
#include <cmath>

#include "render/ray/scene.h"

namespace mimo::render::ray {

using Vec = std::array<double, 3>;

constexpr double kPi = 3.14159265358979323846;
// Nothing that is drawn is farther away or larger, m: of such numbers, squares and products still fit floats.
constexpr double kFarthest = 1e12;
inline bool is_near(double v) { return std::abs(v) < kFarthest; }  // false of what is no number

inline double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec plus(const Vec& a, const Vec& b, double k) { return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]}; }
inline Vec column(const std::array<double, 9>& m, int k) { return {m[k], m[3 + k], m[6 + k]}; }
inline Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec unit(const Vec& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? Vec{a[0] / length, a[1] / length, a[2] / length} : Vec{0, 0, 1};
}
inline Vec to_local(const Solid& solid, const Vec& v) {
  return {dot(column(solid.rotation, 0), v), dot(column(solid.rotation, 1), v), dot(column(solid.rotation, 2), v)};
}
inline std::array<float, 3> narrow(const Vec& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
inline std::array<float, 3> three(const float* v) { return {v[0], v[1], v[2]}; }

}  // namespace mimo::render::ray
