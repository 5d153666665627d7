#include "senses/touch/shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/length.h"
#include "engine/physics.h"
#include "senses/touch/hull.h"

namespace mimo::senses::touch {
namespace {

// A point on the seam of two geoms must not vanish from both because of rounding.
constexpr double kTolerance = 1e-9;  // m

double distance_to_axis(const Vec3& point, double half_length) {
  const double beyond = std::max(std::abs(point.z()) - half_length, 0.0);
  return length_of(point.x(), point.y(), beyond);
}

// Depth below an ellipsoid's surface, exact to first order where it matters: at the surface.
double ellipsoid_depth(const Vec3& radii, const Vec3& point) {
  const Vec3 scaled = point.cwiseQuotient(radii);
  const double slope = 2 * scaled.cwiseQuotient(radii).norm();
  const double level = 1 - scaled.squaredNorm();
  return slope > 0 ? level / slope : radii.minCoeff();
}

// How deep a point lies below the surface; negative outside. Exact near the surface.
double depth(const Shape& shape, const Vec3& point) {
  const Vec3& size = shape.size;
  switch (shape.form) {
    case Shape::Form::kNone: return -1;
    case Shape::Form::kSphere: return size.x() - point.norm();
    case Shape::Form::kCapsule: return size.x() - distance_to_axis(point, size.y());
    case Shape::Form::kCylinder:
      return std::min(size.x() - length_of(point.x(), point.y()), size.y() - std::abs(point.z()));
    case Shape::Form::kBox: return (size - point.cwiseAbs()).minCoeff();
    case Shape::Form::kEllipsoid: return ellipsoid_depth(size, point);
    case Shape::Form::kMesh: return shape.hull->depth(point);
  }
  return -1;
}

}  // namespace

bool has_shape(const mjModel& model, int geom) {
  return model.geom_type[geom] != mjGEOM_PLANE && model.geom_type[geom] != mjGEOM_HFIELD;
}

Shape shape_of(const mjModel& model, int geom) {
  const Vec3 size(model.geom_size + 3 * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE: return {Shape::Form::kSphere, size};
    case mjGEOM_CAPSULE: return {Shape::Form::kCapsule, size};
    case mjGEOM_CYLINDER: return {Shape::Form::kCylinder, size};
    case mjGEOM_BOX: return {Shape::Form::kBox, size};
    case mjGEOM_ELLIPSOID: return {Shape::Form::kEllipsoid, size};
    case mjGEOM_MESH:
      return {Shape::Form::kMesh, Vec3::Zero(), std::make_shared<const Hull>(hull_of(model, model.geom_dataid[geom]))};
    default: return {};
  }
}

Eigen::Matrix3d rotation_of(const mjModel& model, int geom) {
  const double* quat = model.geom_quat + 4 * geom;
  return Eigen::Quaterniond(quat[0], quat[1], quat[2], quat[3]).normalized().toRotationMatrix();
}

bool inside(const Shape& shape, const Vec3& point) { return depth(shape, point) > kTolerance; }

}  // namespace mimo::senses::touch
