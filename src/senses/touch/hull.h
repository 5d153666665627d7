// The surface of a mesh where contacts lie: its convex hull, for MuJoCo collides meshes as if they were convex.
#pragma once

#include <vector>

#include "senses/touch/shape.h"

namespace mimo::senses::touch {

struct Triangle {
  Vec3 corner, first, second;  // a corner, and the sides that start there
  Vec3 normal;                 // outward, unit length
  double area;
};

struct Hull {
  std::vector<Triangle> triangles;
  bool closed = true;  // false: the mesh's own triangles, where the model holds no hull of it

  double area() const;
  // How deep a point lies below the surface; negative outside.
  double depth(const Vec3& point) const;
};

// In the frame of the geoms that the mesh is the shape of.
Hull hull_of(const mjModel& model, int mesh);

}  // namespace mimo::senses::touch
