#include "senses/touch/felt.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/functions.h"
#include "engine/contacts.h"
#include "receptors/skin.h"
#include "senses/touch/shape.h"

namespace mimo::senses::touch {
namespace {

constexpr double kReach = 2;  // spacings

double weight(Response response, double distance) {  // in spacings
  if (response == Response::kLinear) return 1 - distance / kReach;
  const double deviations = distance / (kReach / 3);
  return fixed::exp(-0.5 * deviations * deviations);
}

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

Spread::Spread(const Skin& skin, Response response) : skin_(skin), response_(response) {
  shares_.reserve(std::max<std::size_t>(skin.maps().largest(), 1));
}

Span<const Share> Spread::at(int body, int geom, const Vec3& point) {
  const double spacing = skin_.spacing(body);
  const int anchor = skin_.nearest(geom, point);
  shares_.clear();
  if (anchor < 0) return shares_;  // so far away that distances are no numbers: the world is about to fail
  collect(anchor, point, kReach * spacing);
  // No sensor within reach: the whole force must still be felt.
  if (shares_.empty() || !weigh(spacing)) shares_.assign(1, {skin_.nearest_of_body(body, point), 1});
  return shares_;
}

// The sensors within reach, with their distances on the map of the anchor, onto which the point is projected. None if
// the anchor itself is out of reach.
void Spread::collect(int anchor, const Vec3& point, double reach) {
  const Sensor& middle = skin_.sensors()[static_cast<std::size_t>(anchor)];
  const Vec3 offset = point - middle.position;
  shares_.clear();
  if (offset.norm() >= reach) return;
  const Eigen::Vector2d place = middle.frame.bottomRows<2>() * offset;
  const double horizon = square(reach + place.norm());
  for (const Neighbour& neighbour : skin_.maps().of(anchor)) {
    const double x = static_cast<double>(neighbour.x), y = static_cast<double>(neighbour.y);
    if (x * x + y * y > horizon) break;  // the map is sorted
    const double square = (x - place.x()) * (x - place.x()) + (y - place.y()) * (y - place.y());
    if (square < reach * reach) shares_.push_back({neighbour.sensor, std::sqrt(square)});
  }
}

void Spread::keep_nearest() {
  const auto nearest = std::min_element(shares_.begin(), shares_.end(),
                                        [](const Share& a, const Share& b) { return a.weight < b.weight; });
  shares_.assign(1, {nearest->sensor, 1});
}

// Turns distances into weights that add up to 1; false if all of them vanish.
bool Spread::weigh(double spacing) {
  if (response_ == Response::kNearest) {
    keep_nearest();
    return true;
  }
  double sum = 0;
  for (Share& share : shares_) sum += share.weight = weight(response_, share.weight / spacing);
  for (Share& share : shares_) share.weight /= sum;
  return sum > 0;
}

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

Felt::Felt(const Skin& skin, Response response, Wanted wanted, const Things& things)
    : skin_(skin), things_(things), spread_(skin, response), wanted_(wanted), feelings_(skin.sensors().size()) {
  sensors_.reserve(feelings_.size());
  pricks_.reserve(feelings_.size());
}

void Felt::take_in(const mjModel& model, const mjData& data) {
  for (const int sensor : sensors_) feelings_[static_cast<std::size_t>(sensor)] = {};
  sensors_.clear();
  pricks_.clear();
  for (const engine::Meeting& met : engine::Contacts(model, data)) {
    const bool at_first = skin_.covers(met, 0), at_second = skin_.covers(met, 1);
    if (!at_first && !at_second) continue;
    const auto force = pressing(model, data, met.number);
    if (!force) continue;
    if (at_first) add(model, data, press_on(model, data, met, *force, Side::kFirst));
    if (at_second) add(model, data, press_on(model, data, met, *force, Side::kSecond));
  }
}

void Felt::add(const mjModel& model, const mjData& data, const Press& press) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(data.xmat + 9 * press.body);
  const Vec3 point = rotation.transpose() * (press.point - Vec3(data.xpos + 3 * press.body));
  const Vec3 force = rotation.transpose() * press.force;
  const double sliding = wanted_.sliding ? slip_velocity(model, data, press).norm() : 0;
  int nearest = -1;
  double most = -1;
  for (const Share& share : spread_.at(press.body, press.geom, point)) {
    if (!(share.weight > 0)) continue;
    Feeling& feeling = feelings_[static_cast<std::size_t>(share.sensor)];
    const double normal = share.weight * press.normal_force;
    if (feeling.normal == 0) sensors_.push_back(share.sensor);
    feeling.normal += normal;
    feeling.sliding += sliding * normal;
    if (sliding > wanted_.slip_threshold) feeling.lift = std::max(feeling.lift, press.friction * sliding);
    feeling.tangent +=
        share.weight * (skin_.sensors()[static_cast<std::size_t>(share.sensor)].frame.bottomRows<2>() * force);
    if (normal > feeling.strongest) {
      feeling.strongest = normal;
      feeling.other = press.other_thing;
    }
    if (share.weight > most) {
      most = share.weight;
      nearest = share.sensor;
    }
  }
  if (!wanted_.pricks || nearest < 0 || pricks_.size() == pricks_.capacity()) return;
  const bool meets_flesh = skin_.covers(press.other) || things_[press.other_thing].is_flesh;
  const double radius = curvature_radius(model, data, {press.geom, true}, {press.other_geom, meets_flesh}, press.point);
  pricks_.push_back({nearest, receptors::contact_pressure(press.normal_force, radius)});
}

}  // namespace mimo::senses::touch
