#include "receptors/muscles.h"

#include <algorithm>
#include <cmath>

#include "base/functions.h"

namespace mimo::receptors {
namespace {

constexpr double kExponent = 0.3;
constexpr double kTogether = 1 / (1 - kExponent);  // 10/7

// u / w where u + u^0.3 = w. With y = u^0.3 it is y^(10/3) + y = w, whose left side is convex: Newton's steps from
// above come down on the root.
double share_of(double w) {
  double y = std::min(w, fixed::pow(w, kExponent));
  for (int i = 0; i < 60; ++i) {
    const double rest = fixed::pow(y, 1 / kExponent - 1);
    const double next = y - (y * rest + y - w) / (rest / kExponent + 1);
    if (next == y) break;
    y = next;
  }
  return fixed::pow(y, 1 / kExponent) / w;
}

// Between the table's points; x from 0 to 1.
template <typename Table>
double between(const Table& table, double x) {
  const double at = x * static_cast<double>(table.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), table.size() - 2);
  const double part = at - static_cast<double>(i);
  return table[i] + part * (table[i + 1] - table[i]);
}

// Table 1 of Mileusnic et al.; lengths in L0, times in s.
constexpr double kSensory = 10.4649, kPolar = 0.15;       // stiffness, force / L0
constexpr double kSensoryRest = 0.04, kPolarRest = 0.76;  // rest lengths
constexpr double kSensoryThreshold = 0.0423, kPolarThreshold = 0.89;
constexpr double kShare = 0.7, kSecondaryRest = 0.04;  // X and L_secondary
constexpr double kOrigin = 0.46;                       // R
constexpr double kShorteningEase = 3.45314885;         // 0.42^(-10/7): C where it shortens
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
  return pull * (1 / (kSensory + kPolar));
}

// Where the polar region is a tick later. The lever changes on the way: it is the one at the end, as the first look has
// it.
double crept(double balanced, double before, double ease, const Creep& creep) {
  const double ahead = balanced - before, way = std::abs(ahead), lever = before - kOrigin;
  const double eased = ahead < 0 ? ease * kShorteningEase : ease;
  const double moved = creep.moved(way, lever, eased);
  return before + std::copysign(creep.moved(way, lever + std::copysign(moved, ahead), eased), ahead);
}

double primary(const Fibre& fibre, double stretch) {
  return std::max(0.0, fibre.primary * (stretch - (kSensoryThreshold - kSensoryRest)));
}

double secondary(const Fibre& fibre, double stretch, double polar) {
  const double sensory = kShare * kSecondaryRest / kSensoryRest * (stretch - (kSensoryThreshold - kSensoryRest));
  const double polar_part = (1 - kShare) * kSecondaryRest / kPolarRest * (polar - kPolarThreshold);
  return std::max(0.0, fibre.secondary * (sensory + polar_part));
}

constexpr double kGain = 40;  // Hz
constexpr double kScale = 20;

// H(s) = 1 + a s/(s + 0.2) + b s/(s + 2): from (1.7 s^2 + 2.58 s + 0.4) with poles at s^2 + 2.2 s + 0.4 = (s + 0.2)
// (s + 2): a + b = 0.7 and 2 a + 0.2 b = 0.38.
constexpr double kSlowGain = (0.38 - 0.2 * 0.7) / 1.8, kFastGain = 0.7 - kSlowGain;

}  // namespace

Creep::Creep(double tick, double stiffness) : force_(stiffness * fixed::pow(tick, kExponent)) {
  for (std::size_t i = 1; i < kSteps; ++i) {
    shares_[i] = share_of(static_cast<double>(i) / static_cast<double>(kSteps - i));
  }
  shares_[kSteps] = 1;
  for (std::size_t i = 0; i <= kSteps; ++i) powers_[i] = fixed::pow(static_cast<double>(i) / kSteps, kTogether);
}

double Creep::ease(double damping) const { return fixed::pow(force_ / damping, kTogether); }

double Creep::moved(double way, double lever, double ease) const {
  if (lever <= 0 || way == 0) return way;
  const double eased = way * ease;  // w / (1 + w) with w = eased / lever^(10/7)
  return way * between(shares_, eased / (eased + between(powers_, std::min(lever, 1.0))));
}

SpindleTick::SpindleTick(double tick)
    : creep(tick, kSensory + kPolar),
      kept_bag1(fixed::exp(-tick / kBag1Contracts)),
      kept_bag2(fixed::exp(-tick / kBag2Contracts)) {}

void Spindle::rest(double length, const FusimotorDrive& drive) {
  length_ = length;
  drive_ = contracted(drive);
  ease_ = {};
  for (std::size_t i = 0; i < kFibres; ++i) polar_[i] = balanced(kTable[i], drive_[i], length);
}

void Spindle::advance(double length, const FusimotorDrive& drive, const SpindleTick& tick) {
  const std::array<double, kFibres> told = contracted(drive);
  const std::array<double, kFibres> kept = {tick.kept_bag1, tick.kept_bag2, 0};
  length_ = length;
  for (std::size_t i = 0; i < kFibres; ++i) {
    const double contracts = told[i] + kept[i] * (drive_[i] - told[i]);
    if (contracts != drive_[i] || ease_[i] == 0)
      ease_[i] = tick.creep.ease(kTable[i].damping + kTable[i].damping_gain * contracts);
    drive_[i] = contracts;
    polar_[i] = crept(balanced(kTable[i], contracts, length), polar_[i], ease_[i], tick.creep);
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
  ease_ = {};
}

double TendonOrgan::steady_rate(double share) { return kGain * fixed::log1p(kScale * std::max(0.0, share)); }

void TendonOrgan::rest(double share) {
  drive_ = steady_rate(share);
  slow_ = fast_ = 0;
}

void TendonOrgan::advance(double share, double kept_slow, double kept_fast) {
  const double now = steady_rate(share), change = now - drive_;
  slow_ = kept_slow * slow_ + change;
  fast_ = kept_fast * fast_ + change;
  drive_ = now;
}

double TendonOrgan::rate() const { return std::max(0.0, drive_ + kSlowGain * slow_ + kFastGain * fast_); }

void TendonOrgan::save(ByteWriter& to) const {
  for (const double number : {drive_, slow_, fast_}) to.put(number);
}

void TendonOrgan::load(ByteReader& from) {
  for (double* number : {&drive_, &slow_, &fast_}) *number = from.take_finite("a tendon organ");
}

}  // namespace mimo::receptors
