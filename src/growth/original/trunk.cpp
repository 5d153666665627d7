#include "growth/original/measures.h"
#include "growth/original/parts.h"

namespace mimo::growth::original {

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
