#include "receptors/spindle.h"

#include <algorithm>
#include <cmath>

namespace mimo::receptors {
namespace {

// Table 1 of Mileusnic et al.; lengths in L0.
constexpr double kSensory = 10.4649, kPolar = 0.15;       // stiffness, force / L0
constexpr double kSensoryRest = 0.04, kPolarRest = 0.76;  // rest lengths
constexpr double kSensoryThreshold = 0.0423, kPolarThreshold = 0.89;
constexpr double kShare = 0.7, kSecondaryRest = 0.04;  // X and L_secondary
constexpr double kPower = 0.3, kOrigin = 0.46;         // a and R
constexpr double kShortening = 0.42;                   // C where it shortens
constexpr double kOcclusion = 0.156;                   // S

struct Fibre {
  double damping, damping_gain;  // beta0, and beta1 or beta2 of its own drive
  double force_gain;             // Gamma1 or Gamma2
  double primary, secondary;     // G, Hz / L0
};
constexpr Fibre kBag1 = {0.0605, 0.2592, 0.0289, 20000, 0};
constexpr Fibre kBag2 = {0.0822, -0.046, 0.0636, 10000, 7250};
constexpr Fibre kChain = {0.0822, -0.069, 0.0954, 10000, 7250};

double activation(double rate, double half) { return rate * rate / (rate * rate + half * half); }

// How far the sensory region is stretched, L0. Tension at the ends of the fibre is alike: damping and stiffness of the
// polar region against the stiffness of the sensory one.
double sensory_stretch(const Fibre& fibre, double drive, double length, double velocity) {
  const double damping = fibre.damping + fibre.damping_gain * drive;
  const double sense = velocity < 0 ? -kShortening : 1;
  const double lever = std::max(0.0, length - kSensoryRest - 0.02 - kOrigin);
  const double viscous = damping * sense * lever * std::pow(std::abs(velocity), kPower);
  const double force = kPolar * (length - kSensoryRest - kPolarRest) + fibre.force_gain * drive + viscous;
  return force / (kSensory + kPolar);
}

double primary(const Fibre& fibre, double stretch) {
  return std::max(0.0, fibre.primary * (stretch - (kSensoryThreshold - kSensoryRest)));
}

double secondary(const Fibre& fibre, double stretch, double length) {
  const double sensory = kShare * kSecondaryRest / kSensoryRest * (stretch - (kSensoryThreshold - kSensoryRest));
  const double polar = (1 - kShare) * kSecondaryRest / kPolarRest * (length - stretch - kSensoryRest - kPolarThreshold);
  return std::max(0.0, fibre.secondary * (sensory + polar));
}

}  // namespace

Fusimotion::Fusimotion(const FusimotorDrive& drive)
    : bag1(activation(drive.dynamic_rate, 60)),
      bag2(activation(drive.static_rate, 60)),
      chain(activation(drive.static_rate, 90)) {}

SpindleRates spindle(double length, double velocity, const Fusimotion& drive) {
  const double bag1 = sensory_stretch(kBag1, drive.bag1, length, velocity);
  const double bag2 = sensory_stretch(kBag2, drive.bag2, length, velocity);
  const double chain = sensory_stretch(kChain, drive.chain, length, velocity);
  const double dynamic_part = primary(kBag1, bag1), static_part = primary(kBag2, bag2) + primary(kChain, chain);
  const double louder = std::max(dynamic_part, static_part), softer = std::min(dynamic_part, static_part);
  return {louder + kOcclusion * softer, secondary(kBag2, bag2, length) + secondary(kChain, chain, length)};
}

}  // namespace mimo::receptors
