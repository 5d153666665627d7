#include "growth/solids.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/angle.h"
#include "base/length.h"

namespace mimo::growth {
namespace {

using Eigen::Vector3d;

double ball_volume(double radius) { return 4.0 / 3 * kPi * radius * radius * radius; }

double tube_volume(double radius, double half) { return kPi * radius * radius * 2 * half; }

Vector3d tube_inertia(double mass, double radius, double half) {
  const double across = mass * (radius * radius / 4 + half * half / 3);
  return {across, across, mass * radius * radius / 2};
}

// A tube between two halves of a ball. A half's centre of mass is 3/8 of the radius from its flat side.
Vector3d capsule_inertia(double mass, double radius, double half) {
  const double tube = tube_volume(radius, half), ball = ball_volume(radius);
  const double ends = mass * ball / (tube + ball);
  const double round = 0.4 * ends * radius * radius;
  const double across = round + ends * half * (half + 0.75 * radius);
  return tube_inertia(mass - ends, radius, half) + Vector3d(across, across, round);
}

}  // namespace

double volume(const Geom& geom) {
  const Vector& size = geom.size;
  switch (geom.shape) {
    case Shape::kSphere: return ball_volume(size[0]);
    case Shape::kCapsule: return tube_volume(size[0], size[1]) + ball_volume(size[0]);
    case Shape::kCylinder: return tube_volume(size[0], size[1]);
    case Shape::kBox: break;
  }
  return 8 * size[0] * size[1] * size[2];
}

Vector3d inertia(const Geom& geom) {
  const Vector& size = geom.size;
  switch (geom.shape) {
    case Shape::kSphere: return Vector3d::Constant(0.4 * geom.mass * size[0] * size[0]);
    case Shape::kCapsule: return capsule_inertia(geom.mass, size[0], size[1]);
    case Shape::kCylinder: return tube_inertia(geom.mass, size[0], size[1]);
    case Shape::kBox: break;
  }
  const double x = size[0] * size[0], y = size[1] * size[1], z = size[2] * size[2];
  return geom.mass / 3 * Vector3d(y + z, x + z, x + y);
}

double half_extent(const Geom& geom, const Vector3d& direction) {
  const Vector& size = geom.size;
  const double along = std::abs(direction.z()), across = length_of(direction.x(), direction.y());
  switch (geom.shape) {
    case Shape::kSphere: return size[0];
    case Shape::kCapsule: return size[0] + size[1] * along;
    case Shape::kCylinder: return size[0] * across + size[1] * along;
    case Shape::kBox: break;
  }
  return direction.cwiseAbs().dot(Vector3d(size[0], size[1], size[2]));
}

std::array<int, 3> bone_axes(const Geom& geom) {
  const auto& q = geom.orientation;
  const Eigen::Matrix3d turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  std::array<int, 3> axes{};
  for (int i = 0; i < 3; ++i) turn.col(i).cwiseAbs().maxCoeff(&axes[i]);
  return axes;
}

}  // namespace mimo::growth
