#include "receptors/spindle.h"

#include <algorithm>
#include <cmath>

namespace mimo::receptors {
namespace {

// Table 1 of Mileusnic et al.; lengths in L0, times in s.
constexpr double kSensory = 10.4649, kPolar = 0.15;       // stiffness, force / L0
constexpr double kSensoryRest = 0.04, kPolarRest = 0.76;  // rest lengths
constexpr double kSensoryThreshold = 0.0423, kPolarThreshold = 0.89;
constexpr double kShare = 0.7, kSecondaryRest = 0.04;  // X and L_secondary
constexpr double kOrigin = 0.46;                       // R
constexpr double kShortening = 0.42;                   // C where it shortens
constexpr double kOcclusion = 0.156;                   // S
constexpr double kBag1Contracts = 0.149, kBag2Contracts = 0.205;

enum : std::size_t { kBag1, kBag2, kChain };

struct Fibre {
  double damping, damping_gain;  // beta0, and beta1 or beta2 of its own drive
  double force_gain;             // Gamma1 or Gamma2
  double primary, secondary;     // G, Hz / L0
};
constexpr Fibre kTable[] = {
    {0.0605, 0.2592, 0.0289, 20000, 0}, {0.0822, -0.046, 0.0636, 10000, 7250}, {0.0822, -0.069, 0.0954, 10000, 7250}};

double activation(double rate, double half) { return rate * rate / (rate * rate + half * half); }

std::array<double, 3> contracted(const FusimotorDrive& drive) {
  return {activation(drive.dynamic_rate, 60), activation(drive.static_rate, 60), activation(drive.static_rate, 90)};
}

// How long the polar region is where nothing moves.
double balanced(const Fibre& fibre, double drive, double length) {
  const double pull = kSensory * (length - kSensoryRest) + kPolar * kPolarRest - fibre.force_gain * drive;
  return pull / (kSensory + kPolar);
}

// Where the polar region is a tick later. What pulls at it beyond its own stiffness is left to its damping,
// beta C (P - R) |v|^0.3 with v = (P - P before) / tick. With y = |v|^0.3 that is smooth where it stands still:
// Newton's steps from above, where it is convex, come down on the root.
double crept(const Fibre& fibre, double drive, double length, double before, double tick) {
  const double stiffness = kSensory + kPolar, ahead = balanced(fibre, drive, length) - before;
  const double way = ahead < 0 ? -1 : 1, pull = stiffness * std::abs(ahead);
  const double damping = (fibre.damping + fibre.damping_gain * drive) * (ahead < 0 ? kShortening : 1);
  const double lever = std::max(0.0, before - kOrigin);
  if (damping * lever <= 0) return before + ahead;
  double y = std::min(pull / (damping * lever), std::cbrt(pull / (stiffness * tick)));
  constexpr int kMost = 40;
  constexpr double kNear = 1e-5;  // the step after such a step is its square
  for (int i = 0; i < kMost; ++i) {
    const double seventh = y * y * std::cbrt(y), moved = tick * y * seventh;  // y^(7/3), and v tick = y^(10/3) tick
    const double arm = std::max(0.0, lever + way * moved);
    const double slope = 10.0 / 3 * tick * seventh;
    const double over = stiffness * moved + damping * arm * y - pull;
    const double next = std::max(0.0, y - over / (stiffness * slope + damping * (arm + way * slope * y)));
    const bool there = std::abs(next - y) <= kNear * y;
    y = next;
    if (there) break;
  }
  const double moved = tick * y * y * y * std::cbrt(y);
  return before + way * std::min(moved, std::abs(ahead));
}

double primary(const Fibre& fibre, double stretch) {
  return std::max(0.0, fibre.primary * (stretch - (kSensoryThreshold - kSensoryRest)));
}

double secondary(const Fibre& fibre, double stretch, double polar) {
  const double sensory = kShare * kSecondaryRest / kSensoryRest * (stretch - (kSensoryThreshold - kSensoryRest));
  const double polar_part = (1 - kShare) * kSecondaryRest / kPolarRest * (polar - kPolarThreshold);
  return std::max(0.0, fibre.secondary * (sensory + polar_part));
}

}  // namespace

SpindleTick::SpindleTick(double tick)
    : seconds(tick), kept_bag1(std::exp(-tick / kBag1Contracts)), kept_bag2(std::exp(-tick / kBag2Contracts)) {}

void Spindle::rest(double length, const FusimotorDrive& drive) {
  length_ = length;
  drive_ = contracted(drive);
  for (std::size_t i = 0; i < kFibres; ++i) polar_[i] = balanced(kTable[i], drive_[i], length);
}

void Spindle::advance(double length, const FusimotorDrive& drive, const SpindleTick& tick) {
  const std::array<double, kFibres> told = contracted(drive);
  const std::array<double, kFibres> kept = {tick.kept_bag1, tick.kept_bag2, 0};
  length_ = length;
  for (std::size_t i = 0; i < kFibres; ++i) {
    drive_[i] = told[i] + kept[i] * (drive_[i] - told[i]);
    polar_[i] = crept(kTable[i], drive_[i], length, polar_[i], tick.seconds);
  }
}

SpindleRates Spindle::rates() const {
  const auto stretch = [this](std::size_t fibre) { return length_ - polar_[fibre] - kSensoryRest; };
  const double dynamic_part = primary(kTable[kBag1], stretch(kBag1));
  const double static_part = primary(kTable[kBag2], stretch(kBag2)) + primary(kTable[kChain], stretch(kChain));
  const double louder = std::max(dynamic_part, static_part), softer = std::min(dynamic_part, static_part);
  return {louder + kOcclusion * softer, secondary(kTable[kBag2], stretch(kBag2), polar_[kBag2]) +
                                            secondary(kTable[kChain], stretch(kChain), polar_[kChain])};
}

void Spindle::save(ByteWriter& to) const {
  to.put(length_);
  for (const double number : drive_) to.put(number);
  for (const double number : polar_) to.put(number);
}

void Spindle::load(ByteReader& from) {
  length_ = from.take_finite("a spindle");
  for (double& number : drive_) number = from.take_finite("a spindle");
  for (double& number : polar_) number = from.take_finite("a spindle");
}

}  // namespace mimo::receptors
