#include "growth/original/measures.h"
#include "growth/original/parts.h"

namespace mimo::growth::original {
namespace {

// A capsule that hangs from its bone.
void set(Geom& geom, double radius, double half_length) {
  geom.size = {radius, half_length, 0};
  geom.position = {0, 0, half_length};
}

// Half length of a limb without the round ends.
double upper_half(double age) {
  const auto straight = [](double length, double radius) { return length - radius; };
  return 0.0536 * straight(half(Measure::kShoulderElbow, age), half(Measure::kUpperArm, age)) /
         straight(half_at_18(Measure::kShoulderElbow), half_at_18(Measure::kUpperArm));
}

double lower_half(double age) {
  const auto straight = [](double arm, double hand, double radius) { return arm - hand - radius; };
  return 0.037 *
         straight(half(Measure::kElbowHand, age), half(Measure::kHandLength, age), half(Measure::kForearm, age)) /
         straight(half_at_18(Measure::kElbowHand), half_at_18(Measure::kHandLength), half_at_18(Measure::kForearm));
}

}  // namespace

void grow_arm(const Parts& parts, const Side& side, double age) {
  const double k = ratio(Measure::kHipBreadth, age);
  const double radius = 0.024 * ratio(Measure::kUpperArm, age), upper = upper_half(age);
  parts.bone(side.prefix + "upper_arm").position = {0, side.left * (0.088 * k + radius / 4), 0.090 * k};
  parts.joint("robot:" + side.prefix + "shoulder_horizontal").position = {0, 0, 0};
  set(parts.geom(side.prefix + "uarm1"), radius, upper);
  parts.bone(side.prefix + "lower_arm").position = {0, 0, 2 * upper};
  set(parts.geom(side.prefix + "larm"), 0.023 * ratio(Measure::kForearm, age), lower_half(age));
}

}  // namespace mimo::growth::original
