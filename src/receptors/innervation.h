// How many afferents a piece of skin has, and how sensitive its region is.
#pragma once

#include <cstddef>

namespace mimo::receptors {

enum class Region { kFace, kHand, kFinger, kFoot, kTrunk, kArm, kThigh, kLeg };

// In the order of the outputs: SA1, RA, PC, SA2.
constexpr std::size_t kTouchKinds = 4;

// Afferents of a kind per square metre, of adults: 241 per cm^2 at a fingertip, 58 in the palm (Johansson and Vallbo
// 1979), 9 on the trunk (Corniani and Saal 2020); elsewhere 241 (2 mm / two-point distance)^1.2, an estimate that meets
// these three within 8 %. How they divide among the kinds is an estimate, too. Hairy skin has no PC here; fingers have
// no SA2 (Pare 2003 found next to none).
double afferents_per_square_metre(Region region, std::size_t kind);

// Factors of the rates of cold and warm receptors, estimates.
double thermal_factor(Region region);
// Factors of the threshold of pain by pressure, and of the force that makes an infant withdraw; estimates.
double pain_factor(Region region);
double withdrawal_factor(Region region);

}  // namespace mimo::receptors
