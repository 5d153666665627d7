// Points spread over the surface of one geom, a given distance apart. Counts and places are those of the original.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "senses/touch/shape.h"

namespace mimo::senses::touch {

struct SurfacePoint {
  Vec3 position;
  Vec3 normal;  // outward, unit length; zero for the only point of a geom
};

struct Surface {
  std::vector<SurfacePoint> points;
  std::vector<std::pair<int, int>> edges;  // neighbours on the surface

  // A geom too small for its spacing has one point, in its middle.
  bool single() const { return points.size() == 1; }
};

Surface sample(const OuterShape& shape, double spacing);

double area(const OuterShape& shape);

// About how many points that gives; for refusing what would fill the memory.
double expected_points(const OuterShape& shape, double spacing);

// Sampling one kind of shape.
Surface sample_box(const Vec3& half, double spacing);
Surface sample_sphere(double radius, double spacing);
Surface sample_ellipsoid(const Vec3& radii, double spacing);
Surface sample_capsule(double radius, double half_length, double spacing);
Surface sample_cylinder(double radius, double half_length, double spacing);
Surface sample_mesh(const Hull& hull, double spacing);
Surface single_point();

// How far apart touch sensors are on each part of the body.

// Distance in metres by a body's name without its agent's prefix; 0, no skin, for bodies that are not the infant's own.
double default_spacing(std::string_view body);

}  // namespace mimo::senses::touch
