#include "sound/ringing.h"

#include <cmath>

#include "base/angle.h"
#include "sound/air.h"

namespace mimo::sound {
namespace {

constexpr double kSquareDecay = 27.6;  // a sine that falls by 60 dB in T has the energy gain^2 T / 27.6

// How much of a frequency is in a blow that lasts so long.
double spectrum(double frequency, double duration) {
  const double turns = 2 * frequency * duration;
  if (std::abs(turns - 1) < 1e-6) return kPi / 4;
  return std::abs(std::cos(kPi / 2 * turns) / (1 - turns * turns));
}

}  // namespace

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
