// How many afferents a piece of skin has, and how sensitive its region is.
#pragma once

#include <cstddef>

namespace mimo::receptors {

enum class Region { kFace, kEye, kHand, kFinger, kFoot, kTrunk, kArm, kThigh, kLeg };

// In the order of the outputs: SA1, RA, PC, SA2.
constexpr std::size_t kTouchKinds = 4;

// Afferents of a kind per square metre, of adults: 241 per cm^2 at a fingertip, 58 in the palm (Johansson and Vallbo
// 1979), 9 on the trunk (Corniani and Saal 2020); elsewhere 241 (2 mm / two-point distance)^1.2, an estimate that meets
// these three within 8 %. How they divide among the kinds is an estimate, too. Hairy skin has no PC here; fingers have
// no SA2 (Pare 2003 found next to none).
double afferents_per_square_metre(Region region, std::size_t kind);
// A kind's share of all there.
double share_of(Region region, std::size_t kind);

// What shares a number of afferents, both sides of the body together.
enum class Territory { kFace, kEyes, kHands, kFeet, kTrunk, kArms, kThighs, kLegs };
Territory territory_of(Region region);  // a finger is part of the hand

// How many afferents a person has there, of all kinds and at any age: skin grows, and they move apart (Peters and
// Goldreich 2013). 15 % of 230 000 are in the palms of both hands, 19 % in face and lips (Corniani and Saal 2020). The
// rest of an adult's 1.8 m^2, divided by the chart of Lund and Browder (1944, from memory), has 153 360 at the
// densities above. An eye has as many as the face has on the 2 cm^2 that lids leave open, an estimate. All add up to
// 231 664.
double afferents_of(Territory territory);

// Factors of the rates of cold and warm receptors, estimates.
double thermal_factor(Region region);
// Factor of the threshold of pain by pressure, an estimate.
double pain_factor(Region region);

}  // namespace mimo::receptors
