#include "receptors/innervation.h"

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

}  // namespace mimo::receptors
