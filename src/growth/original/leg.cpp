#include "growth/original/measures.h"
#include "growth/original/parts.h"

namespace mimo::growth::original {
namespace {

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

}  // namespace mimo::growth::original
