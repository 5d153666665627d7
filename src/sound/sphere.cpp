#include "sound/sphere.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "sound/air.h"

namespace mimo::sound {
namespace {

constexpr double kNearest = 1.05;                      // radii
constexpr double kLargest = 1;                         // m: larger heads have the filter of this one
constexpr double kLowMatch = 2000, kHighMatch = 4000;  // Hz

// The shortest way round the sphere, in radii.
double path(double distance, double angle, double cosine) {
  if (cosine >= 1 / distance) return std::sqrt(distance * distance + 1 - 2 * distance * cosine);
  return std::sqrt(distance * distance - 1) + angle - fixed::acos(1 / distance);
}

// What a source gives at 0 Hz, relative to free air at the middle: the sum over n of (2n + 1) / (n + 1) P_n(cosine) /
// rho^n, in closed form.
double at_rest(double rho, double cosine) {
  const double near = 1 / rho, far = std::sqrt(1 - 2 * near * cosine + near * near);
  const double round = cosine > 1 - 1e-9 ? 1 / (1 - near) : (near - cosine + far) / (1 - cosine);
  return 2 / far - rho * fixed::log(round);
}

// What the three parts of a power are at a frequency.
using Powers = std::array<double, 3>;
Powers powers_at(double frequency, double rate) {
  const double half = square(fixed::sin(kPi * frequency / rate));
  return {1 - half, half, 4 * half * (1 - half)};
}
double sum(const Powers& of, const Powers& at) { return of[0] * at[0] + of[1] * at[1] + of[2] * at[2]; }

}  // namespace

SphereFilter sphere_filter(double angle) {
  const double at = std::clamp(angle / (5 * kDegree), 0.0, static_cast<double>(kSphereAngles - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(at), kSphereAngles - 2);
  const double share = at - static_cast<double>(i);
  const SphereFilter &a = kSphereTable[i], &b = kSphereTable[i + 1];
  const auto between = [share](double from, double to) { return from + share * (to - from); };
  return {between(a.b1, b.b1), between(a.b2, b.b2), between(a.a1, b.a1), between(a.a2, b.a2)};
}

Way way_to_ear(double radius, double distance, double cosine) {
  const double rho = std::max(distance / radius, kNearest), bounded = std::clamp(cosine, -1.0, 1.0);
  const double angle = fixed::acos(bounded);
  const double length = path(rho, angle, bounded);
  Way way{radius / kSpeed * length, 1 / (length * radius), sphere_filter(angle), std::min(radius, kLargest) / kSpeed};
  // High sounds of near sources are as strong as their way is long; low ones go round the sphere like a field at rest.
  way.filter.still = at_rest(rho, bounded) * length / rho;
  way.filter.b1 *= std::sqrt(way.filter.still);
  return way;
}

bool can_be(const Way& way) {
  const SphereFilter& f = way.filter;
  if (f.a2 == 0) return true;
  const auto within = [](double number) { return number >= 1e-4 && number <= 10; };
  return within(f.a1) && within(f.a2) && within(f.b1) && within(f.b2) && within(f.still) && way.size > 0 &&
         way.size < 1;
}

std::complex<double> response(const Way& way, double frequency) {
  const SphereFilter& f = way.filter;
  const std::complex<double> s(0, 2 * kPi * frequency * way.size);
  return quotient(f.still + s * (f.b1 + s * f.b2), 1.0 + s * (f.a1 + s * f.a2));
}

// The bilinear transform would shift what happens at 4 kHz to 3.2. Instead the poles go where they belong, and the
// zeros so that as much is left as of the filter itself at 0, 2 and 4 kHz (M. Vicanek, Matched second order digital
// filters, 2016). What that changes of the delay of low frequencies is given back as such.
Coefficients coefficients(const Way& way, double rate) {
  const SphereFilter& f = way.filter;
  if (f.a2 <= 0 || way.size <= 0) return {};
  const double tick = 1 / (rate * way.size);
  // The poles, two real ones or a complex pair, after a tick: their sum and their product.
  const double scale = tick / (2 * f.a2), square = f.a1 * f.a1 - 4 * f.a2, root = std::sqrt(std::abs(square));
  const double both = fixed::exp(-scale * f.a1);
  const double apart =
      square < 0 ? fixed::cos(scale * root) : 0.5 * (fixed::exp(scale * root) + fixed::exp(-scale * root));
  const double a1 = -2 * both * apart, a2 = both * both;
  // |1 + a1/z + a2/z^2|^2 is a sum of three, of which the first is left at 0 Hz; the zeros' is another such sum.
  const Powers poles = {(1 + a1 + a2) * (1 + a1 + a2), (1 - a1 + a2) * (1 - a1 + a2), -4 * a2};
  const Powers low = powers_at(kLowMatch, rate), high = powers_at(kHighMatch, rate);
  const double still = f.still * f.still * poles[0];
  const double at_low = std::norm(response(way, kLowMatch)) * sum(poles, low) - still * low[0];
  const double at_high = std::norm(response(way, kHighMatch)) * sum(poles, high) - still * high[0];
  const double whole = low[1] * high[2] - low[2] * high[1];
  const double odd = std::max(0.0, (at_low * high[2] - at_high * low[2]) / whole);
  const double product = (low[1] * at_high - high[1] * at_low) / whole;
  const double even = 0.5 * (std::sqrt(still) + std::sqrt(odd));
  const double b0 = 0.5 * (even + std::sqrt(std::max(0.0, even * even + product)));
  const double b1 = 0.5 * (std::sqrt(still) - std::sqrt(odd)), b2 = -product / (4 * b0);
  const double delay = (b1 + 2 * b2) / (b0 + b1 + b2) - (a1 + 2 * a2) / (1 + a1 + a2);
  return {static_cast<float>(b0), static_cast<float>(b1), static_cast<float>(b2),
          static_cast<float>(a1), static_cast<float>(a2), (f.a1 - f.b1 / f.still) / tick - delay};
}

float Filter::next(const Coefficients& c, float in) {
  float out = c.b0 * in + c.b1 * x_[0] + c.b2 * x_[1] - c.a1 * y_[0] - c.a2 * y_[1];
  if (std::abs(out) < kNothing) out = 0;
  x_[1] = x_[0];
  x_[0] = in;
  y_[1] = y_[0];
  y_[0] = out;
  return out;
}

void Filter::save(ByteWriter& to) const {
  to.put(Span<const float>(x_, 2));
  to.put(Span<const float>(y_, 2));
}

void Filter::load(ByteReader& from) {
  constexpr float kLoudest = 1e6F;  // Pa
  from.take(Span<float>(x_, 2));
  from.take(Span<float>(y_, 2));
  for (const float* two : {x_, y_}) {
    const bool sane = std::abs(two[0]) <= kLoudest && std::abs(two[1]) <= kLoudest;  // no NaN either
    require(sane, "the state holds a sound whose numbers are out of range");
  }
}

}  // namespace mimo::sound
