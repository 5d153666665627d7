#include "receptors/skin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/functions.h"

namespace mimo::receptors {
namespace {

constexpr double kPerSquareMetre = 1e4;  // of a number per cm^2

// Of all kinds, per cm^2.
double density(Region region) {
  switch (region) {
    case Region::kFace:
    case Region::kEye: return 26;
    case Region::kHand: return 58;
    case Region::kFinger: return 241;
    case Region::kFoot: return 21;
    case Region::kTrunk: return 9;
    case Region::kArm: return 12;
    case Region::kThigh:
    case Region::kLeg: return 7;
  }
  return 0;
}

bool in_face(Region region) { return region == Region::kFace || region == Region::kEye; }

bool hairless(Region region) { return region == Region::kHand || region == Region::kFinger || region == Region::kFoot; }

// Amplitude, micrometres, at which half of TouchSim's afferents fire once a cycle of this frequency.
struct Threshold {
  double frequency, amplitude;
};
constexpr Threshold kRa[] = {{1, 1016}, {2, 517}, {5, 210},   {10, 107},  {20, 68},
                             {40, 68},  {60, 85}, {100, 134}, {150, 330}, {200, 1016}};
constexpr Threshold kPc[] = {{2, 1995},   {5, 413},   {10, 263},  {20, 68},   {40, 17.7}, {60, 14.1},
                             {100, 14.1}, {150, 5.7}, {200, 3.7}, {300, 1.9}, {400, 4.6}};

// The amplitude's share of the threshold, from a half to 1. Straight lines between the points' logarithms; beyond the
// table nothing is felt. What is clear from two points alone needs no logarithms.
template <std::size_t kCount>
double over_threshold(const Threshold (&table)[kCount], double frequency, double amplitude) {
  if (frequency < table[0].frequency || frequency > table[kCount - 1].frequency) return 0.5;
  std::size_t i = 1;
  while (table[i].frequency < frequency) ++i;
  const Threshold &low = table[i - 1], &high = table[i];
  if (amplitude >= std::max(low.amplitude, high.amplitude)) return 1;
  if (amplitude <= 0.5 * std::min(low.amplitude, high.amplitude)) return 0.5;
  const double share = fixed::log(frequency / low.frequency) / fixed::log(high.frequency / low.frequency);
  const double threshold = low.amplitude * fixed::pow(high.amplitude / low.amplitude, share);
  return std::clamp(amplitude / threshold, 0.5, 1.0);
}

// One spike a ridge above the threshold, none below half of it.
template <std::size_t kCount>
double of_sliding(const Threshold (&table)[kCount], double speed, const Texture& texture) {
  if (!(texture.wavelength > 0)) return 0;
  const double frequency = speed / texture.wavelength;
  return frequency * (2 * over_threshold(table, frequency, texture.amplitude * 1e6) - 1);
}

constexpr double kHeatCapacity = 3600;  // of a millimetre of skin, J/(m^2 K)
constexpr double kTouch = 350;          // W/(m^2 K)

Eight bell(const Eight& x) {
  constexpr float kLeast = -87;  // nobody feels so little
  Eight result;
  for (int i = 0; i < 8; ++i) result[i] = fixed::exp_of_negative(std::max(-x[i] * x[i], kLeast));
  return result;
}

constexpr double kSoftness = 0.2e6;  // Pa
constexpr double kPi = 3.14159265358979323846;

}  // namespace

double afferents_per_square_metre(Region region, std::size_t kind) {
  constexpr double kHairless[kTouchKinds] = {0.25, 0.45, 0.10, 0.20};
  constexpr double kHairy[kTouchKinds] = {0.30, 0.50, 0, 0.20};  // slow and fast ones in equal parts
  if (region == Region::kFinger && kind == 3) return 0;
  return kPerSquareMetre * density(region) * (hairless(region) ? kHairless : kHairy)[kind];
}

double share_of(Region region, std::size_t kind) {
  double all = 0;
  for (std::size_t other = 0; other < kTouchKinds; ++other) all += afferents_per_square_metre(region, other);
  return afferents_per_square_metre(region, kind) / all;
}

Territory territory_of(Region region) {
  switch (region) {
    case Region::kFace: return Territory::kFace;
    case Region::kEye: return Territory::kEyes;
    case Region::kHand:
    case Region::kFinger: return Territory::kHands;
    case Region::kFoot: return Territory::kFeet;
    case Region::kTrunk: return Territory::kTrunk;
    case Region::kArm: return Territory::kArms;
    case Region::kThigh: return Territory::kThighs;
    case Region::kLeg: return Territory::kLegs;
  }
  return Territory::kTrunk;
}

double afferents_of(Territory territory) {
  constexpr double kAll = 230000, kSkin = 18000;  // cm^2
  switch (territory) {
    case Territory::kFace: return 0.19 * kAll;
    case Territory::kEyes: return 2 * 2 * density(Region::kEye);
    case Territory::kHands: return 0.15 * kAll;
    case Territory::kFeet: return 0.07 * kSkin * density(Region::kFoot);
    case Territory::kTrunk: return 0.34 * kSkin * density(Region::kTrunk);  // neck, buttocks and all
    case Territory::kArms: return 0.14 * kSkin * density(Region::kArm);
    case Territory::kThighs: return 0.19 * kSkin * density(Region::kThigh);
    case Territory::kLegs: return 0.14 * kSkin * density(Region::kLeg);
  }
  return 0;
}

double thermal_factor(Region region) {
  if (in_face(region)) return 2;
  return region == Region::kFoot ? 0.5 : 1;
}

double pain_factor(Region region) { return in_face(region) ? 0.7 : 1; }

double sa1_rate(double depth, double speed) {
  const double held = 48 * std::max(0.0, depth / kMillimetre - 0.08);
  return std::min(350.0, held + 4.5 * std::max(0.0, speed / kMillimetre));
}

double ra_rate(double speed) {
  const double over = std::max(0.0, std::abs(speed) / kMillimetre - 3);
  return 250 * over / (over + 60);
}

double sa2_rate(double along, double all) {
  constexpr double kLeast = 0.3 * kMillimetre;
  if (all < kLeast) return 10;
  return std::max(0.0, 10 + 30 * along / kMillimetre);
}

double ra_of_sliding(double speed, const Texture& texture) { return of_sliding(kRa, speed, texture); }
double pc_of_sliding(double speed, const Texture& texture) { return of_sliding(kPc, speed, texture); }

double resting_temperature(const Surroundings& around) {
  return (around.blood * around.core + around.loss * around.air) / (around.blood + around.loss);
}

double skin_kept(const Surroundings& around, double seconds) {
  return fixed::exp(-seconds * (around.blood + around.loss) / kHeatCapacity);
}

double interface_temperature(double skin, double other, double other_effusivity) {
  return (kSkinEffusivity * skin + other_effusivity * other) / (kSkinEffusivity + other_effusivity);
}

Touching touching(double before, double other, double other_effusivity) {
  if (!(other_effusivity > 0)) return {before, 0, 0};
  const double together = kSkinEffusivity * other_effusivity / (kSkinEffusivity + other_effusivity);
  return {before, interface_temperature(before, other, other_effusivity) - before, kTouch / together};
}

Eight cold_rates(const Eight& temperature, const Eight& change) {
  return (8 * bell((temperature - 30) / 6) - 20 * change).max(0.0F);
}

Eight warm_rates(const Eight& temperature, const Eight& change) {
  return (12 * bell((temperature - 41) / 5) + 10 * change).max(0.0F);
}

double contact_pressure(double force, double radius) {
  if (!(force > 0) || !(radius > 0)) return 0;
  const double patch = fixed::cbrt(3 * force * radius / (4 * kSoftness));
  return force / (kPi * patch * patch);
}

}  // namespace mimo::receptors
