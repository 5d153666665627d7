// The outer shape of a geom in its own frame (long axis z), and how sharp it is where it touches.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "engine/physics.h"

typedef struct mjModel_ mjModel;

namespace mimo::senses::touch {

// The outer shape of a geom, in the geom's own frame (long axis z).

using Vec3 = Eigen::Vector3d;

struct Hull;

struct OuterShape {
  enum class Form { kNone, kSphere, kCapsule, kCylinder, kBox, kEllipsoid, kMesh };

  Form form = Form::kNone;
  Vec3 size = Vec3::Zero();  // as MuJoCo's: radius; radius and half length; three half lengths or radii
  std::shared_ptr<const Hull> hull = nullptr;  // of a mesh
};

// Whether a geom has a shape that can have a skin: planes and height fields have none.
bool has_shape(const mjModel& model, int geom);
OuterShape shape_of(const mjModel& model, int geom);
// From the geom's frame to its body's.
Eigen::Matrix3d rotation_of(const mjModel& model, int geom);

// Whether a point lies inside by more than a nanometre.
bool inside(const OuterShape& shape, const Vec3& point);

// The surface of a mesh where contacts lie: its convex hull, for MuJoCo collides meshes as if they were convex.

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

// How sharp what touches is: the radius of curvature where two geoms press on each other.

// A box or cylinder that stands for flesh has no edges: it is as round there as it is thin.
struct Surfaced {
  int geom;  // -1: a flex, which is flat where it touches
  bool is_flesh;
};

// Of both surfaces together, m; the point is in the world. Flat things on each other count as 100 mm.
double curvature_radius(const mjModel& model, const mjData& data, const Surfaced& one, const Surfaced& other,
                        const Vec3& point);

}  // namespace mimo::senses::touch
