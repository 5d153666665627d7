// The original's rules for trunk, head, arms and legs.
#include "growth/original/original.h"

namespace mimo::growth::original {
namespace {

// A capsule that hangs from its bone.
void hang(Geom& geom, double radius, double half_length) {
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

void grow_thigh(const Parts& parts, const Side& side, double age) {
  const auto straight = [](double length, double radius) { return length - radius; };
  const double radius = 0.037 * ratio(Measure::kThigh, age);
  const double half_length = 0.0625 * straight(half(Measure::kRumpKnee, age), half(Measure::kThigh, age)) /
                             straight(half_at_18(Measure::kRumpKnee), half_at_18(Measure::kThigh));
  const double apart = 0.051 * ratio(Measure::kHipBreadth, age);
  parts.bone(side.prefix + "upper_leg").position = {0.005, side.left * apart, -0.007};
  set(parts.geom(side.prefix + "upper_leg1"), {radius, half_length, 0}, {0, 0, -0.0645 / 0.0625 * half_length});
  parts.bone(side.prefix + "lower_leg").position = {0, 0, -(2 * radius + half_length)};
}

void grow_shank(const Parts& parts, const Side& side, double age) {
  const double q = ratio(Measure::kKneeSole, age), calf = 0.044 * q, ankle = 0.028 * q;
  set(parts.geom(side.prefix + "lower_leg1"), {half(Measure::kCalf, age), calf, 0}, {0, 0, -calf});
  set(parts.geom(side.prefix + "lower_leg2"), {half(Measure::kAnkle, age), ankle, 0}, {0, 0, -3 * calf});
  parts.bone(side.prefix + "foot").position = {0, 0, -4 * calf};
}

// Half sizes.
struct Sole {
  double x;
  double breadth;
  double thick;
  double ball;  // where the toes begin
};

Sole sole_at(double age) {
  const double x = 0.035 * ratio(Measure::kFootLength, age);
  const double thick = 0.01 * (half(Measure::kFootLength, age) + half(Measure::kFootBreadth, age)) /
                       (half_at_18(Measure::kFootLength) + half_at_18(Measure::kFootBreadth));
  return {x, half(Measure::kFootBreadth, age), thick, x + x * 0.019 / 0.035};
}

void grow_foot(const Parts& parts, const Side& side, const Sole& sole) {
  set(parts.geom(side.prefix + "foot1"), {sole.breadth - kGap, sole.thick - kGap, 0}, {-sole.x * 0.016 / 0.035, 0, 0});
  set(parts.geom(side.prefix + "foot2"), {sole.x, sole.breadth, sole.thick}, {sole.x * 0.019 / 0.035, 0, 0});
  set(parts.geom(side.prefix + "foot3"), {sole.thick - kGap, sole.breadth - 2 * kGap, 0}, {sole.ball, 0, 0});
  for (const char* joint : {"foot1", "foot2", "foot3"}) {
    parts.joint("robot:" + side.prefix + joint).position = {0, 0, 1.5 * sole.thick};
  }
}

void grow_mitten_toes(const Parts& parts, const Side& side, const Sole& sole, double age) {
  const double x = 0.007 * ratio(Measure::kFootLength, age);
  parts.bone(side.prefix + "toes").position = {sole.ball, 0, 0};
  set(parts.geom(side.prefix + "toes1"), {x, sole.breadth - kGap, sole.thick - kGap}, {x, 0, 0});
  set(parts.geom(side.prefix + "toes2"), {sole.thick, sole.breadth, 0}, {2 * x, 0, 0});
}

// The big toe, and the four others.
void grow_toes(const Parts& parts, const Side& side, const Sole& sole, double age) {
  const double x = 0.0095 * ratio(Measure::kFootLength, age), wide = ratio(Measure::kFootBreadth, age);
  parts.bone(side.prefix + "toes").position = {sole.ball, side.left * 0.3 * sole.breadth, 0};
  set(parts.geom(side.prefix + "toes1"), {x, 0.016 * wide, sole.thick - kGap}, {x, 0, 0});
  set(parts.geom(side.prefix + "toes2"), {sole.thick, 0.0165 * wide, 0}, {2 * x, 0, 0});
  parts.bone(side.prefix + "big_toe").position = {sole.ball, -side.left * 0.7 * sole.breadth, 0};
  set(parts.geom(side.prefix + "big_toe1"), {x, 0.007 * wide, sole.thick - kGap}, {x, 0, 0});
  set(parts.geom(side.prefix + "big_toe2"), {sole.thick, 0.0075 * wide, 0}, {2 * x, 0, 0});
}

}  // namespace

void grow_arm(const Parts& parts, const Side& side, double age) {
  const double k = ratio(Measure::kHipBreadth, age);
  const double radius = 0.024 * ratio(Measure::kUpperArm, age), upper = upper_half(age);
  parts.bone(side.prefix + "upper_arm").position = {0, side.left * (0.088 * k + radius / 4), 0.090 * k};
  parts.joint("robot:" + side.prefix + "shoulder_horizontal").position = {0, 0, 0};
  hang(parts.geom(side.prefix + "uarm1"), radius, upper);
  parts.bone(side.prefix + "lower_arm").position = {0, 0, 2 * upper};
  hang(parts.geom(side.prefix + "larm"), 0.023 * ratio(Measure::kForearm, age), lower_half(age));
}

void grow_leg(const Parts& parts, const Side& side, double age) {
  grow_thigh(parts, side, age);
  grow_shank(parts, side, age);
  const Sole sole = sole_at(age);
  grow_foot(parts, side, sole);
  if (parts.has_bone(side.prefix + "big_toe")) {
    grow_toes(parts, side, sole, age);
  } else {
    grow_mitten_toes(parts, side, sole, age);
  }
}

void grow_trunk(const Parts& parts, double age) {
  const double k = ratio(Measure::kHipBreadth, age);
  set(parts.geom("lb"), {0.048 * k, 0.043 * k, 0}, {-0.002, 0, 0.005 * k});
  set(parts.geom("cb"), {0.053 * k, 0.035 * k, 0}, {0.005, 0, -0.008 * k});
  set(parts.geom("ub1"), {0.052 * k, 0.035 * k, 0}, {0.007, 0, -0.032 * k});
  set(parts.geom("ub2"), {0.048 * k, 0.039 * k, 0}, {0.004, 0, 0.030 * k});
  set(parts.geom("ub3"), {0.041 * k, 0.047 * k, 0}, {0, 0, 0.090 * k});
  parts.bone("lower_body").position = {0.002, 0, 0.076 * k};
  parts.bone("upper_body").position = {-0.002, 0, 0.091 * k};
  for (const char* joint : {"robot:hip_lean1", "robot:hip_rot1", "robot:hip_bend1"}) {
    parts.joint(joint).position = {0, 0, -0.053 * k};
  }
  for (const char* joint : {"robot:hip_lean2", "robot:hip_rot2", "robot:hip_bend2"}) {
    parts.joint(joint).position = {0, 0, -0.052 * k};
  }
}

void grow_head(const Parts& parts, double age) {
  constexpr double kNeck = 2e-6;  // what is left of a neck in the original
  const double s = ratio(Measure::kHead, age), radius = 0.0735 * s;
  parts.bone("head").position = {0, 0, 0.131 * ratio(Measure::kHipBreadth, age) + kNeck};
  set(parts.geom("head"), {radius, 0, 0}, {0.01 * s, 0, radius});
  parts.joint("robot:head_tilt").position = {0, 0, 0.01225 * s};
  parts.joint("robot:head_tilt_side").position = {0, 0, 0.0245 * s};
  parts.mark("vestibular").position = {0.01, 0, radius};
  for (const Side& side : {Side{"left_", 1}, Side{"right_", -1}}) {
    parts.bone(side.prefix + "eye").position = {0.07 * s, side.left * 0.0245 * s, 0.067375 * s};
    parts.geom(side.prefix + "eye").size[0] = 0.01125 * s;
  }
}

}  // namespace mimo::growth::original
