#include "reflexes/pattern.h"

#include <algorithm>

#include "base/functions.h"

namespace mimo::reflexes {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Estimated: when arms that were thrown open begin to close, and how long two steps take.
constexpr double kEmbrace = 0.5, kTurning = 0.1, kTwoSteps = 1.2;  // s

constexpr Limb kOwn = Limb::kOwn, kOther = Limb::kOther;
constexpr Phase kAlways = Phase::kAlways, kOpen = Phase::kFirst, kClose = Phase::kSecond, kAcross = Phase::kCrossed;

constexpr Pull kPalmarGrasp[] = {
    {kOwn, "ff_knuckle", 1},   {kOwn, "ff_middle", 1},    {kOwn, "ff_distal", 1},    {kOwn, "mf_knuckle", 1},
    {kOwn, "mf_middle", 1},    {kOwn, "mf_distal", 1},    {kOwn, "rf_knuckle", 1},   {kOwn, "rf_middle", 1},
    {kOwn, "rf_distal", 1},    {kOwn, "lf_knuckle", 1},   {kOwn, "lf_middle", 1},    {kOwn, "lf_distal", 1},
    {kOwn, "thumb_side", 0.5}, {kOwn, "thumb_middle", 1}, {kOwn, "thumb_distal", 1},
};

constexpr Pull kPlantarGrasp[] = {{kOwn, "toes", -1}, {kOwn, "big_toe", -1, kAlways, false}};

constexpr Pull kRooting[] = {{Limb::kMiddle, "head_swivel", 1}};

// Hands open only where there are fingers to open.
constexpr Pull kMoro[] = {
    {kOwn, "shoulder_abduction", 1, kOpen},
    {kOwn, "shoulder_horizontal", -1, kOpen},
    {kOwn, "elbow", 1, kOpen},
    {kOwn, "fingers", 1, kOpen, false},
    {kOwn, "ff_knuckle", -1, kOpen, false},
    {kOwn, "mf_knuckle", -1, kOpen, false},
    {kOwn, "rf_knuckle", -1, kOpen, false},
    {kOwn, "lf_knuckle", -1, kOpen, false},
    {kOwn, "shoulder_abduction", -0.5, kClose},
    {kOwn, "shoulder_horizontal", 1, kClose},
    {kOwn, "elbow", -1, kClose},
};

constexpr Pull kTonicNeck[] = {
    {kOwn, "elbow", 1},    {kOwn, "hip_flex", 1},    {kOwn, "knee", 1},
    {kOther, "elbow", -1}, {kOther, "hip_flex", -1}, {kOther, "knee", -1},
};

constexpr Pull kStepping[] = {{kOwn, "hip_flex", -1}, {kOwn, "knee", -1}, {kOwn, "foot_flexion", 0.5}};

constexpr Pull kWithdrawal[] = {
    {kOwn, "hip_flex", -1},        {kOwn, "knee", -1},
    {kOwn, "foot_flexion", 1},     {kOther, "hip_flex", -1, kAcross},
    {kOther, "knee", -1, kAcross}, {kOther, "foot_flexion", 1, kAcross},
};

template <std::size_t kCount>
Span<const Pull> all_of(const Pull (&pulls)[kCount]) {
  return {pulls, kCount};
}

double share_of_phase(Phase phase, double seconds, double months) {
  const double closing = std::clamp((seconds - kEmbrace) / kTurning + 0.5, 0.0, 1.0);
  switch (phase) {
    case Phase::kFirst: return 1 - closing;
    case Phase::kSecond: return closing;
    case Phase::kCrossed: return crossed(months);
    case Phase::kAlways: break;
  }
  return 1;
}

}  // namespace

Span<const Pull> pattern(Reflex reflex) {
  switch (reflex) {
    case Reflex::kPalmarGrasp: return all_of(kPalmarGrasp);
    case Reflex::kPlantarGrasp: return all_of(kPlantarGrasp);
    case Reflex::kRooting: return all_of(kRooting);
    case Reflex::kMoro: return all_of(kMoro);
    case Reflex::kTonicNeck: return all_of(kTonicNeck);
    case Reflex::kStepping: return all_of(kStepping);
    case Reflex::kWithdrawal: return all_of(kWithdrawal);
  }
  return {};
}

std::string motor_name(const Pull& pull, Side side) {
  if (pull.limb == Limb::kMiddle) return std::string("act:") + pull.motor;
  const bool left = (side == Side::kLeft) == (pull.limb == Limb::kOwn);
  return std::string("act:") + kSideNames[left ? 0 : 1] + "_" + pull.motor;
}

double share(const Pull& pull, Side side, double seconds, double months) {
  const bool mirrored = pull.limb == Limb::kMiddle && side == Side::kRight;
  return (mirrored ? -pull.share : pull.share) * share_of_phase(pull.phase, seconds, months);
}

double swing(double seconds, bool leads) {
  const double turn = fixed::sin(2 * kPi * seconds / kTwoSteps);
  return std::max(0.0, leads ? turn : -turn);
}

}  // namespace mimo::reflexes
