#include "senses/touch/felt.h"

#include <algorithm>

#include "receptors/nociceptors.h"
#include "senses/touch/curvature.h"

namespace mimo::senses::touch {

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
