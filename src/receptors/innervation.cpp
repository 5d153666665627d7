#include "receptors/innervation.h"

namespace mimo::receptors {
namespace {

constexpr double kPerSquareMetre = 1e4;  // of a number per cm^2

// Of all kinds, per cm^2.
double density(Region region) {
  switch (region) {
    case Region::kFace: return 26;
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

bool hairless(Region region) { return region == Region::kHand || region == Region::kFinger || region == Region::kFoot; }

}  // namespace

double afferents_per_square_metre(Region region, std::size_t kind) {
  constexpr double kHairless[kTouchKinds] = {0.25, 0.45, 0.10, 0.20};
  constexpr double kHairy[kTouchKinds] = {0.30, 0.50, 0, 0.20};  // slow and fast ones in equal parts
  if (region == Region::kFinger && kind == 3) return 0;
  return kPerSquareMetre * density(region) * (hairless(region) ? kHairless : kHairy)[kind];
}

double thermal_factor(Region region) {
  if (region == Region::kFace) return 2;
  return region == Region::kFoot ? 0.5 : 1;
}

double pain_factor(Region region) { return region == Region::kFace ? 0.7 : 1; }

double withdrawal_factor(Region region) {
  switch (region) {
    case Region::kFace: return 0.7;
    case Region::kHand:
    case Region::kFinger:
    case Region::kFoot: return 1;
    case Region::kThigh: return 2;
    default: return 1.5;
  }
}

}  // namespace mimo::receptors
