#include "document/flat.h"

#include <cmath>

namespace mimo::document {
namespace {

using Point = std::array<double, 3>;

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length(const Point& a) { return std::sqrt(dot(a, a)); }

// The point for which a measure is largest.
template <typename Measure>
const Point& farthest(const std::vector<Point>& points, Measure&& measure) {
  const Point* best = &points.front();
  double most = -1;
  for (const Point& point : points) {
    const double here = measure(point);
    if (here > most) {
      most = here;
      best = &point;
    }
  }
  return *best;
}

}  // namespace

// A wide triangle among the points, and what is farthest from its plane.
bool is_flat(const std::vector<Point>& points) {
  if (points.empty()) return true;
  constexpr double kFlat = 3e-6;  // of the extent: below 1e-6 Qhull says at times that a hull is narrow
  const Point& any = points.front();
  const Point& one = farthest(points, [&](const Point& p) { return length(difference(p, any)); });
  const Point& two = farthest(points, [&](const Point& p) { return length(difference(p, one)); });
  const Point along = difference(two, one);
  const double extent = length(along);
  const auto from_line = [&](const Point& p) { return length(cross(along, difference(p, one))); };
  const Point& three = farthest(points, from_line);
  if (from_line(three) <= kFlat * extent * extent) return true;
  const Point normal = cross(along, difference(three, one));
  const auto from_plane = [&](const Point& p) { return std::abs(dot(normal, difference(p, one))) / length(normal); };
  return from_plane(farthest(points, from_plane)) <= kFlat * extent;
}

}  // namespace mimo::document
