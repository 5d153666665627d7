// The outer shape of a geom, in the geom's own frame (long axis z).
#pragma once

#include <Eigen/Core>
#include <memory>

typedef struct mjModel_ mjModel;

namespace mimo::senses::touch {

using Vec3 = Eigen::Vector3d;

struct Hull;

struct Shape {
  enum class Form { kNone, kSphere, kCapsule, kCylinder, kBox, kEllipsoid, kMesh };

  Form form = Form::kNone;
  Vec3 size = Vec3::Zero();  // as MuJoCo's: radius; radius and half length; three half lengths or radii
  std::shared_ptr<const Hull> hull = nullptr;  // of a mesh
};

// Whether a geom has a shape that can have a skin: planes and height fields have none.
bool has_shape(const mjModel& model, int geom);
Shape shape_of(const mjModel& model, int geom);
// From the geom's frame to its body's.
Eigen::Matrix3d rotation_of(const mjModel& model, int geom);

// Whether a point lies inside by more than a nanometre.
bool inside(const Shape& shape, const Vec3& point);

}  // namespace mimo::senses::touch
