#include "sound/impact.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/functions.h"
#include "base/numbers.h"
#include "sound/air.h"

namespace mimo::sound {
namespace {

constexpr double kSquareDecay = 27.6;  // a sine that falls by 60 dB in T has the energy gain^2 T / 27.6

// How much of a frequency is in a blow that lasts so long.
double spectrum(double frequency, double duration) {
  const double turns = 2 * frequency * duration;
  if (std::abs(turns - 1) < 1e-6) return kPi / 4;
  return std::abs(fixed::cos(kPi / 2 * turns) / (1 - turns * turns));
}

}  // namespace

Strike strike(const Struck& a, const Struck& b, double speed) {
  const double inverse = a.inverse_mass + b.inverse_mass;
  if (inverse <= 0 || speed <= 0) return {};
  constexpr double kFlattest = 0.1;  // 1/m: two flat sides meet with an edge or a corner, never all at once
  const double curvature = std::max(a.curvature + b.curvature, kFlattest), mass = 1 / inverse;
  const double stiffness = 1 / (compliance(a.solid) + compliance(b.solid));
  const double duration = 2.87 * fixed::pow(mass * mass * curvature / (stiffness * stiffness * speed), 0.2);
  return {duration, mass, speed};
}

Click click(const Strike& strike, double inverse_mass, double radius, double cosine) {
  // The half sine's area is the impulse over the body's own mass.
  const double change = strike.mass * strike.speed * (1 + kRestitution) * inverse_mass;
  const double peak = change * kPi / (2 * strike.duration);
  return {strike.duration, kAirDensity * radius * radius * radius * cosine * peak, radius / kSpeed};
}

// (1 + s/c) / (2 + 2 s T + s^2 T^2), at 1 m, answers sin(w t), which starts at 0, with what lasts and what the poles at
// (-1 +- i)/T add, which dies away.
ClickWave::ClickWave(const Click& click) : click_(click), turn_(kPi / click.duration) {
  using Complex = std::complex<double>;
  const double settling = click.settling;
  const Complex s(0, turn_), pole(-1 / settling, 1 / settling);
  const Complex lasting = quotient(1.0 + s / kSpeed, 2.0 + 2.0 * s * settling + s * s * settling * settling);
  const Complex dying = quotient((1.0 + pole / kSpeed) * turn_,
                                 (pole * pole + turn_ * turn_) * settling * settling * Complex(0, 2 / settling));
  lasting_ = {click.scale * lasting.real(), click.scale * lasting.imag()};
  dying_ = {2 * click.scale * dying.real(), 2 * click.scale * dying.imag()};
}

double ClickWave::answer(double time) const {
  if (time <= 0) return 0;
  const double angle = turn_ * time, decay = time / click_.settling;
  const double steady = lasting_[0] * fixed::sin(angle) + lasting_[1] * fixed::cos(angle);
  if (decay > 40) return steady;
  return steady + fixed::exp(-decay) * (dying_[0] * fixed::cos(decay) - dying_[1] * fixed::sin(decay));
}

double ClickWave::at(double time) const {
  if (click_.scale <= 0 || time <= 0 || time >= click_.end()) return 0;
  return answer(time) + answer(time - click_.duration);
}

double Click::peak() const { return scale <= 0 ? 0 : scale * kPi / (2 * kSpeed * duration); }

const ModeSet& mode_set(int timbre, double length) {
  constexpr std::array<double, kSizes - 1> kLimits = {0.1, 0.5, 1, 3, 12};  // m
  std::size_t size = 0;
  while (size < kLimits.size() && length > kLimits[size]) ++size;
  return kModeTable[static_cast<std::size_t>(kTimbreTable[static_cast<std::size_t>(timbre)].sets[size])];
}

Ringing ringing(const Strike& strike, const Struck& body) {
  Ringing made;
  if (body.solid.timbre < 0 || body.solid.efficiency <= 0 || strike.mass <= 0) return made;
  const ModeSet& set = mode_set(body.solid.timbre, body.length);
  double sum = 0;
  for (std::size_t i = 0; i < set.count; ++i) sum += set.modes[i].gain * set.modes[i].gain * set.modes[i].decay;
  // The share of the blow's energy that goes through a sphere around it: the level that modes would have together if
  // the blow held all frequencies.
  const double power = body.solid.efficiency * 0.5 * strike.mass * strike.speed * strike.speed * kAirDensity * kSpeed;
  const double level = std::sqrt(power * kSquareDecay / (4 * kPi * sum));
  made.count = set.count;
  for (std::size_t i = 0; i < set.count; ++i) {
    made.modes[i] = set.modes[i];
    made.modes[i].gain *= level * spectrum(set.modes[i].frequency, strike.duration);
  }
  return made;
}

}  // namespace mimo::sound
