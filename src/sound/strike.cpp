#include "sound/strike.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/angle.h"
#include "sound/air.h"

namespace mimo::sound {
namespace {

// By how much a material gives way.
double compliance(const Solid& solid) { return (1 - solid.poisson * solid.poisson) / solid.young; }

// What sin(w t), which starts at 0, becomes by (1 + s/c) / (2 + 2 s T + s^2 T^2), at 1 m. The poles are (-1 +- i)/T.
double answer(double t, double w, double settling) {
  if (t <= 0) return 0;
  using Complex = std::complex<double>;
  const Complex s(0, w);
  const Complex lasting = (1.0 + s / kSpeed) / (2.0 + 2.0 * s * settling + s * s * settling * settling);
  const double steady = std::imag(lasting * Complex(std::cos(w * t), std::sin(w * t)));
  const double decay = t / settling;
  if (decay > 40) return steady;
  // Residue at the upper pole of (1 + s/c) w / ((s^2 + w^2) T^2 (s - p)(s - p*)), twice its real part.
  const Complex pole(-1 / settling, 1 / settling);
  const Complex residue =
      (1.0 + pole / kSpeed) * w / ((pole * pole + w * w) * settling * settling * Complex(0, 2 / settling));
  return steady + 2 * std::exp(-decay) * std::real(residue * Complex(std::cos(decay), std::sin(decay)));
}

}  // namespace

Strike strike(const Struck& a, const Struck& b, double speed) {
  const double inverse = a.inverse_mass + b.inverse_mass;
  if (inverse <= 0 || speed <= 0) return {};
  constexpr double kFlattest = 0.1;  // 1/m: two flat sides meet with an edge or a corner, never all at once
  const double curvature = std::max(a.curvature + b.curvature, kFlattest), mass = 1 / inverse;
  const double stiffness = 1 / (compliance(a.solid) + compliance(b.solid));
  const double duration = 2.87 * std::pow(mass * mass * curvature / (stiffness * stiffness * speed), 0.2);
  return {duration, mass, speed};
}

Click click(const Strike& strike, double inverse_mass, double radius, double cosine) {
  // The half sine's area is the impulse over the body's own mass.
  const double change = strike.mass * strike.speed * (1 + kRestitution) * inverse_mass;
  const double peak = change * kPi / (2 * strike.duration);
  return {strike.duration, kAirDensity * radius * radius * radius * cosine * peak, radius / kSpeed};
}

double Click::at(double time) const {
  if (scale <= 0 || time <= 0 || time >= end()) return 0;
  const double w = kPi / duration;
  return scale * (answer(time, w, settling) + answer(time - duration, w, settling));
}

double Click::peak() const { return scale <= 0 ? 0 : scale * kPi / (2 * kSpeed * duration); }

}  // namespace mimo::sound
