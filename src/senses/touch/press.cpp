#include "senses/touch/press.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/ground.h"

namespace mimo::senses::touch {
namespace {

constexpr double kNoForce = 1e-9;  // N

// How much of the friction that the normal force allows is called for. A cone with a round section adds its components
// as a vector, a pyramid adds their magnitudes.
double friction_use(const mjModel& model, const mjContact& contact, const ContactForce& force) {
  const bool round = model.opt.cone == mjCONE_ELLIPTIC;
  double sum = 0;
  for (std::size_t i = 1; i < static_cast<std::size_t>(contact.dim); ++i) {
    const double share = std::abs(force[i]) / (contact.friction[i - 1] * force[0]);
    sum += round ? share * share : share;
  }
  return std::min(round ? std::sqrt(sum) : sum, 1.0);
}

// Velocity of the point of a body that is at this place now.
Vec3 velocity_at(const mjModel& model, const mjData& data, int body, const Vec3& point) {
  const auto motion = engine::body_velocity(model, data, body);
  const Vec3 linear(motion.data()), angular(motion.data() + 3);
  return linear + angular.cross(point - Vec3(data.xpos + 3 * body));
}

}  // namespace

std::optional<ContactForce> pressing(const mjModel& model, const mjData& data, int contact) {
  const ContactForce force = engine::contact_force(model, data, contact);
  if (force[0] < kNoForce) return std::nullopt;
  return force;
}

Press press_on(const mjModel& model, const mjData& data, const engine::Meeting& met, const ContactForce& force,
               Side side) {
  const mjContact& contact = data.contact[met.number];
  const bool first = side == Side::kFirst;
  const double sign = first ? 1 : -1;
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(contact.frame);
  const Vec3 normal = frame.row(0).transpose();
  Press press;
  press.body = met.bodies[first ? 0 : 1];
  press.other = met.bodies[first ? 1 : 0];
  press.geom = met.geoms[first ? 0 : 1];
  press.other_geom = met.geoms[first ? 1 : 0];
  press.other_thing = press.other_geom >= 0 ? press.other_geom : model.ngeom + met.flexes[first ? 1 : 0];
  // MuJoCo's point lies midway between the surfaces.
  press.point = Vec3(contact.pos) + sign * 0.5 * engine::overlap_of(model, data, met) * normal;
  press.normal = sign * normal;
  press.force = -sign * (frame.transpose() * Vec3(force.data()));
  press.normal_force = force[0];
  press.friction = contact.dim > 1 ? contact.friction[0] : 0;
  press.friction_use = friction_use(model, contact, force);
  return press;
}

Vec3 slip_velocity(const mjModel& model, const mjData& data, const Press& press) {
  const Vec3 velocity =
      velocity_at(model, data, press.other, press.point) - velocity_at(model, data, press.body, press.point);
  return velocity - velocity.dot(press.normal) * press.normal;
}

}  // namespace mimo::senses::touch
