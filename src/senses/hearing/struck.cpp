#include "senses/hearing/struck.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "engine/contacts.h"
#include "engine/physics.h"

namespace mimo::senses {
namespace {

using Vec3 = Eigen::Vector3d;

constexpr double kLongest = 3;  // m: what stands still and is longer in all is a floor or a wall, and does not ring

double ball_of(double volume) { return std::cbrt(3 * volume / (4 * kPi)); }

Vec3 velocity(const mjModel& model, const mjData& data, int body, const Vec3& point) {
  const Vec3 spin(data.cvel + 6 * body), speed(data.cvel + 6 * body + 3);
  return speed + spin.cross(point - Vec3(data.subtree_com + 3 * model.body_rootid[body]));
}

// What rolls: 1/m; 0 for what has sides.
double roundness(const mjModel& model, int geom) {
  const mjtNum* size = model.geom_size + 3 * geom;
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
    case mjGEOM_CAPSULE:
    case mjGEOM_CYLINDER: return 1 / size[0];
    case mjGEOM_ELLIPSOID: return 1 / std::cbrt(size[0] * size[1] * size[2]);
    default: return 0;
  }
}

}  // namespace

sound::Struck struck(const mjModel& model, int geom, const sound::Solid& solid) {
  sound::Struck made;
  made.solid = solid;
  made.inverse_mass = model.body_invweight0[2 * model.geom_bodyid[geom]];
  const mjtNum* size = model.geom_size + 3 * geom;
  const double a = size[0], b = size[1], c = size[2];
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      made.curvature = 1 / a;
      made.radius = a;
      made.length = 6 * a;
      break;
    case mjGEOM_CAPSULE:
      made.curvature = 1 / a;
      made.radius = ball_of(kPi * a * a * (2 * b + 4 * a / 3));
      made.length = 6 * a + 2 * b;
      break;
    case mjGEOM_CYLINDER:
      made.curvature = 1 / a;
      made.radius = ball_of(2 * kPi * a * a * b);
      made.length = 4 * a + 2 * b;
      break;
    case mjGEOM_ELLIPSOID:
      made.curvature = 1 / std::cbrt(a * b * c);
      made.radius = std::cbrt(a * b * c);
      made.length = 2 * (a + b + c);
      break;
    case mjGEOM_BOX:
    case mjGEOM_MESH:  // its size is that of its box
      // What moves meets others with its corners, about as round as it is small; tables and walls with their sides.
      made.curvature = made.inverse_mass > 0 ? 1 / std::max(1e-4, std::min({a, b, c})) : 0;
      made.radius = ball_of(8 * a * b * c);
      made.length = 2 * (a + b + c);
      break;
    default:  // ground
      made.solid.efficiency = 0;
  }
  if (made.inverse_mass <= 0 && made.length > kLongest) made.solid.efficiency = 0;
  return made;
}

double approach(const mjModel& model, const mjData& data, const engine::Meeting& met) {
  const mjContact& contact = data.contact[met.number];
  const Vec3 point(contact.pos), normal(contact.frame);  // from the first geom to the second
  const Vec3 first = velocity(model, data, met.bodies[0], point);
  const Vec3 second = velocity(model, data, met.bodies[1], point);
  return (first - second).dot(normal);
}

sound::Sliding sliding(const mjModel& model, const mjData& data, const engine::Meeting& met) {
  const mjContact& contact = data.contact[met.number];
  const auto [first, second] = met.bodies;
  const Vec3 point(contact.pos), normal(contact.frame);
  const Vec3 slip = velocity(model, data, first, point) - velocity(model, data, second, point);
  sound::Sliding made;
  made.speed = (slip - slip.dot(normal) * normal).norm();
  if (made.speed <= sound::kSlowestScrape) {
    const Vec3 spin = Vec3(data.cvel + 6 * first) - Vec3(data.cvel + 6 * second);
    const double curvature = roundness(model, met.geoms[0]) + roundness(model, met.geoms[1]);
    made.speed = curvature > 0 ? (spin - spin.dot(normal) * normal).norm() / curvature : 0;
    made.rolls = true;
  }
  if (made.speed <= sound::kSlowestScrape) return {};
  made.force = engine::contact_force(model, data, met.number)[0];
  return made;
}

}  // namespace mimo::senses
