#include "sound/sphere.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "sound/air.h"

namespace mimo::sound {
namespace {

constexpr double kNearest = 1.05;  // radii

// Delay of a far source relative to the sphere's middle, in radius / speed of sound (Woodworth 1938).
double woodworth(double angle) { return angle <= kPi / 2 ? -std::cos(angle) : angle - kPi / 2; }

// The shortest way round the sphere, in radii.
double path(double distance, double angle, double cosine) {
  if (cosine >= 1 / distance) return std::sqrt(distance * distance + 1 - 2 * distance * cosine);
  return std::sqrt(distance * distance - 1) + angle - std::acos(1 / distance);
}

}  // namespace

SphereFilter sphere_filter(double angle) {
  const double at = std::clamp(angle / (5 * kDegree), 0.0, static_cast<double>(kSphereAngles - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(at), kSphereAngles - 2);
  const double share = at - static_cast<double>(i);
  const SphereFilter &a = kSphereTable[i], &b = kSphereTable[i + 1];
  return {a.alpha + share * (b.alpha - a.alpha), a.gamma + share * (b.gamma - a.gamma),
          a.tau + share * (b.tau - a.tau)};
}

Way way_to_ear(double radius, double distance, double cosine) {
  const double rho = std::max(distance / radius, kNearest), bounded = std::clamp(cosine, -1.0, 1.0);
  const double angle = std::acos(bounded);
  const SphereFilter filter = sphere_filter(angle);
  const double length = path(rho, angle, bounded);
  // The table's delay is that of a far source; nearer ones differ by their path.
  return {radius / kSpeed * (length + filter.tau - woodworth(angle)), 1 / (length * radius), filter.alpha,
          filter.gamma * kSpeed / radius};
}

std::complex<double> response(const Way& way, double frequency) {
  const std::complex<double> s(0, 2 * kPi * frequency / way.corner);
  return (1.0 + way.alpha * s) / (1.0 + s);
}

Coefficients coefficients(const Way& way, double rate) {
  const double k = 2 * rate / way.corner;
  return {static_cast<float>((1 + way.alpha * k) / (1 + k)), static_cast<float>((1 - way.alpha * k) / (1 + k)),
          static_cast<float>((1 - k) / (1 + k))};
}

}  // namespace mimo::sound
