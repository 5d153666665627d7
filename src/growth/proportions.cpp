#include "growth/proportions.h"

#include <algorithm>
#include <cmath>

#include "growth/curve.h"
#include "growth/parts.h"
#include "growth/solids.h"

namespace mimo::growth {
namespace {

// Exponents of the length ratio. Estimated: fitted to the eight youngest groups of Snyder et al. 1977, UM-HSRI-77-17,
// within 2 to 5 %. Single studies of newborns, which were left out, agree.
constexpr double kUpperArm = 1.04;
constexpr double kForearm = 0.97;
constexpr double kHand = 0.89;
constexpr double kThigh = 1.38;
constexpr double kShank = 1.14;
constexpr double kFoot = 1.05;
constexpr double kFootBreadth = 1.0;

// Exponents of the slenderness ratio, from the same source.
constexpr double kChest = 0.58;
constexpr double kWaist = 0.55;
constexpr double kHip = 0.63;
constexpr double kUpperArmGirth = 0.56;
constexpr double kForearmGirth = 0.535;
constexpr double kHandGirth = 0.61;
constexpr double kThighGirth = 0.75;
constexpr double kCalfGirth = 0.78;
constexpr double kAnkleGirth = 0.70;
constexpr double kShoulder = 0.71;

// The base's measures that make up its stature, m.
struct Stack {
  double trunk;  // from the hip joints to the head
  double head;
  double thigh;
  double shank;
  double sole;
};

Stack stack_of(const Skeleton& base) {
  const auto height = [&](const char* name) { return bone(base, name).position[2]; };
  const Geom& head = geom(base, "head");
  return {height("lower_body") + height("upper_body") + height("head") - height("left_upper_leg"),
          head.position[2] + head.size[0], -height("left_lower_leg"), -height("left_foot"), sole_height(base)};
}

}  // namespace

double sole_height(const Skeleton& base) {
  double lowest = 0;
  for (const Geom& geom : bone(base, "left_foot").geoms) {
    const std::array<int, 3> axes = bone_axes(geom);
    Eigen::Vector3d up = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) up[i] = axes[i] == 2 ? 1 : 0;
    lowest = std::max(lowest, half_extent(geom, up) - geom.position[2]);
  }
  return lowest;
}

// Sitting height over length, mean of the sexes, of the Dutch Growth Study 1997 (Fredriks et al. 2000-2005). From a
// single copy.
double sitting_share(double age) {
  constexpr Curve kShare({0, 3, 6, 9, 12, 15, 18, 21, 24},
                         {0.6923, 0.6825, 0.6714, 0.6599, 0.6482, 0.6364, 0.6248, 0.6133, 0.6024});
  return kShare(age);
}

Lengths lengths(const Skeleton& base, const Drivers& drivers, double age, double stretch) {
  const Stack was = stack_of(base);
  const double upper = was.trunk + was.head, lower = was.thigh + was.shank + was.sole;
  const double l = drivers.l;
  // What the upper part gains, the legs lose. Written so that all factors are exactly 1 for the base.
  const double shift = stretch * l * (upper + lower) * (sitting_share(age) - sitting_share(kBase));
  const double thigh = std::pow(l, kThigh), shank = std::pow(l, kShank), foot = std::pow(l, kFoot);
  const double closure = (stretch * l * lower - shift) / (was.thigh * thigh + was.shank * shank + was.sole * foot);
  return {stretch * l,
          drivers.h,
          (stretch * l * upper + shift - was.head * drivers.h) / (upper - was.head),
          stretch * std::pow(l, kUpperArm),
          stretch * std::pow(l, kForearm),
          stretch * std::pow(l, kHand),
          thigh * closure,
          shank * closure,
          foot * closure,
          stretch * foot,
          stretch * std::pow(l, kFootBreadth),
          closure};
}

Girths girths(const Drivers& drivers, double closure) {
  const auto girth = [&](double exponent) { return std::pow(drivers.w, exponent) * closure; };
  return {girth(kChest),        girth(kWaist),
          girth(kHip),          girth(kUpperArmGirth),
          girth(kForearmGirth), girth(kHandGirth),
          girth(kThighGirth),   girth(kCalfGirth),
          girth(kAnkleGirth),   std::pow(drivers.frame, kShoulder)};
}

}  // namespace mimo::growth
