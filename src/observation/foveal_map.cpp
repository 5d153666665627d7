#include "observation/foveal_map.h"

#include <cmath>

#include "base/length.h"

namespace mimo::observation {

FovealMap::FovealMap(std::size_t height, std::size_t width, double focal, double strength)
    : strength_(strength),
      middle_x_(static_cast<double>(width - 1) / 2),
      middle_y_(static_cast<double>(height - 1) / 2),
      corner_(length_of(middle_x_, middle_y_)),
      focal_(focal) {}

double FovealMap::distance(Place place) const { return length_of(place[0] - middle_x_, place[1] - middle_y_); }

FovealMap::Place FovealMap::scaled(Place place, double factor) const {
  return {middle_x_ + factor * (place[0] - middle_x_), middle_y_ + factor * (place[1] - middle_y_)};
}

double FovealMap::shrinkage(double r) const {
  return even() ? 1 : std::log1p(strength_) / strength_ * std::exp(r / corner_ * std::log1p(strength_));
}

FovealMap::Place FovealMap::plain(Place foveated) const {
  const double r = distance(foveated);
  if (even() || r == 0) return foveated;
  return scaled(foveated, corner_ * std::expm1(r / corner_ * std::log1p(strength_)) / strength_ / r);
}

FovealMap::Place FovealMap::foveated(Place plain) const {
  const double r = distance(plain);
  if (even() || r == 0) return plain;
  return scaled(plain, corner_ * std::log1p(strength_ * r / corner_) / std::log1p(strength_) / r);
}

std::array<double, 3> FovealMap::direction(Place foveated) const {
  const Place at = plain(foveated);
  const double right = at[0] - middle_x_, down = at[1] - middle_y_;
  const double length = std::sqrt(right * right + down * down + focal_ * focal_);
  return {right / length, -down / length, -focal_ / length};
}

std::optional<FovealMap::Place> FovealMap::place(const std::array<double, 3>& direction) const {
  if (!(direction[2] < 0)) return std::nullopt;
  return foveated(
      {middle_x_ + focal_ * direction[0] / -direction[2], middle_y_ + focal_ * direction[1] / direction[2]});
}

FovealMap map_of(const Field& picture) {
  return {picture.shape[0], picture.shape[1], picture.focal, picture.foveation};
}

}  // namespace mimo::observation
