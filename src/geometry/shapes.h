// Simple shapes as triangles, each in its own frame. Segments: how many straight pieces a circle becomes, a multiple of
// four.
#pragma once

#include <functional>

#include "geometry/mesh.h"

namespace mimo::geometry {

// Upright, around the origin.
Mesh plane(double half_x, double half_y);
Mesh box(const Eigen::Vector3d& half);
Mesh ellipsoid(const Eigen::Vector3d& radii, int segments);
// Around the z axis; half: of the length, without the round ends.
Mesh capsule(double radius, double half, int segments);
Mesh cylinder(double radius, double half, int segments);

}  // namespace mimo::geometry
