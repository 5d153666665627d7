#include "senses/touch/surface.h"

#include "base/angle.h"
#include "senses/touch/hull.h"

namespace mimo::senses::touch {
double area(const Shape& shape) {
  const Vec3& s = shape.size;
  switch (shape.form) {
    case Shape::Form::kSphere: return 4 * kPi * s.x() * s.x();
    case Shape::Form::kCapsule: return 4 * kPi * s.x() * (s.x() + s.y());
    case Shape::Form::kCylinder: return 2 * kPi * s.x() * (s.x() + 2 * s.y());
    case Shape::Form::kBox: return 8 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
    case Shape::Form::kEllipsoid: return 4 * kPi * s.maxCoeff() * s.maxCoeff();
    case Shape::Form::kMesh: return shape.hull->area();
    case Shape::Form::kNone: break;
  }
  return 0;
}

Surface single_point() { return {{{Vec3::Zero(), Vec3::Zero()}}, {}}; }

double expected_points(const Shape& shape, double spacing) {
  // The second term is what a needle without area still has along its length.
  return area(shape) / (spacing * spacing) + 8 * shape.size.sum() / spacing;
}

Surface sample(const Shape& shape, double spacing) {
  const Vec3& size = shape.size;
  switch (shape.form) {
    case Shape::Form::kSphere: return sample_sphere(size.x(), spacing);
    case Shape::Form::kCapsule: return sample_capsule(size.x(), size.y(), spacing);
    case Shape::Form::kCylinder: return sample_cylinder(size.x(), size.y(), spacing);
    case Shape::Form::kBox: return sample_box(size, spacing);
    case Shape::Form::kEllipsoid: return sample_ellipsoid(size, spacing);
    case Shape::Form::kMesh: return sample_mesh(*shape.hull, spacing);
    case Shape::Form::kNone: break;
  }
  return {};
}

}  // namespace mimo::senses::touch
