#include "senses/touch/spread.h"

#include <algorithm>
#include <cmath>

namespace mimo::senses::touch {
namespace {

constexpr double kReach = 2;  // spacings

double weight(Response response, double distance) {  // in spacings
  if (response == Response::kLinear) return 1 - distance / kReach;
  const double deviations = distance / (kReach / 3);
  return std::exp(-0.5 * deviations * deviations);
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
  // Nobody within reach: nothing of the force may be lost.
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
  const double horizon = std::pow(reach + place.norm(), 2);
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

}  // namespace mimo::senses::touch
