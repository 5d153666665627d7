// The outer shape of a geom, in the geom's own frame (long axis z).
#pragma once

#include <Eigen/Core>

typedef struct mjModel_ mjModel;

namespace mimo::senses::touch {

using Vec3 = Eigen::Vector3d;

struct Shape {
  enum class Kind { kNone, kSphere, kCapsule, kCylinder, kBox, kEllipsoid };

  Kind kind = Kind::kNone;
  Vec3 size = Vec3::Zero();  // as MuJoCo's: radius; radius and half length; three half lengths or radii
};

// Meshes are taken as the sphere around them; planes and height fields have no skin.
Shape shape_of(const mjModel& model, int geom);

// Whether a point lies inside by more than a nanometre.
bool inside(const Shape& shape, const Vec3& point);

}  // namespace mimo::senses::touch
