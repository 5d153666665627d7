#include "growth/sizes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "base/fail.h"
#include "base/functions.h"
#include "growth/mechanics.h"
#include "growth/skeleton.h"
#include "growth/who.h"

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

// Factors along the axes of a bone.
using Scale = Vector;

void scale(Vector& place, const Scale& by) {
  for (int i = 0; i < 3; ++i) place[i] *= by[i];
}

class Resizer {
 public:
  Resizer(const Skeleton& base, const Lengths& lengths, const Girths& girths)
      : base_(base), lengths_(lengths), girths_(girths) {}

  void resize(Bone& bone) const {
    const Segment segment = segment_of(bone.name);
    const Scale by = factors(segment);
    for (Geom& geom : bone.geoms) resize(geom, segment, by);
    for (Joint& joint : bone.joints) scale(joint.position, by);
    for (Mark& mark : bone.marks) scale(mark.position, by);
    if (bone.parent >= 0) place(bone);
  }

 private:
  // Of whatever lies in a bone's frame. Limbs have their z axis along them, feet their x axis.
  Scale factors(Segment segment) const {
    switch (segment) {
      case Segment::kTrunk: return {lengths_.trunk, lengths_.trunk, lengths_.trunk};
      case Segment::kHead: return {lengths_.head, lengths_.head, lengths_.head};
      case Segment::kUpperArm: return {girths_.upper_arm, girths_.upper_arm, lengths_.upper_arm};
      case Segment::kForearm: return {girths_.forearm, girths_.forearm, lengths_.forearm};
      case Segment::kHand: return {girths_.hand, girths_.hand, lengths_.hand};
      case Segment::kThigh: return {girths_.thigh, girths_.thigh, lengths_.thigh};
      case Segment::kShank: return {girths_.calf, girths_.calf, lengths_.shank};
      case Segment::kFoot: break;
    }
    return {lengths_.foot, lengths_.foot_breadth, lengths_.foot_breadth};
  }

  void resize(Geom& geom, Segment segment, const Scale& by) const {
    const double before = volume(geom);
    scale(geom.position, by);
    if (segment == Segment::kTrunk) {
      resize_whole(geom, trunk_girth(geom.name), lengths_.trunk);
    } else if (segment == Segment::kHand && geom.shape == GeomShape::kCapsule) {
      resize_whole(geom, girths_.hand, lengths_.hand);
    } else if (segment == Segment::kShank && without_side(geom.name) == "lower_leg2") {
      resize_shin(geom, by[2]);
    } else {
      resize_along(geom, by);
    }
    geom.mass *= volume(geom) / before;
  }

  double trunk_girth(const std::string& geom) const {
    if (geom == "lb") return girths_.hip;
    if (geom == "cb" || geom == "ub1") return girths_.waist;
    if (geom == "ub2" || geom == "ub3") return girths_.chest;
    fail(Status::kUnsupported, "the infant's trunk has a geom \"{}\", which growth does not know", geom);
  }

  // Capsules of trunk and fingers are as long as the body is there with their round ends, which lie free or in a row.
  static void resize_whole(Geom& geom, double girth, double length) {
    double& radius = geom.size[0];
    double& half = geom.size[1];
    half = half * length - radius * (girth - length);
    radius *= girth;
  }

  // Its lower end stays inside of the foot, however thick it is.
  void resize_shin(Geom& geom, double length) const {
    geom.position[2] += geom.size[0] * (girths_.ankle - length);
    resize_along(geom, {girths_.ankle, girths_.ankle, length});
  }

  // A limb's capsule is as long as its bone without them. What is round around an axis takes the mean of the two
  // factors across it, so that all volumes but a capsule's go with the product of the three.
  static void resize_along(Geom& geom, const Scale& by) {
    const std::array<int, 3> axes = bone_axes(geom);
    const double x = by[axes[0]], y = by[axes[1]], z = by[axes[2]];
    if (geom.shape == GeomShape::kBox) {
      scale(geom.size, {x, y, z});
    } else {
      geom.size[0] *= x == y ? x : std::sqrt(x * y);
      geom.size[1] *= z;
    }
  }

  void place(Bone& bone) const {
    const std::string_view name = without_side(bone.name);
    scale(bone.position, factors(segment_of(base_.bones[bone.parent].name)));
    const Bone& was = mimo::growth::bone(base_, bone.name);
    if (name == "upper_arm") bone.position[1] = was.position[1] * girths_.shoulder;
    if (name == "upper_leg") bone.position[1] = was.position[1] * girths_.hip;
    if (name == "hand") place_hand(bone, was);
    if (name == "foot") place_foot(bone, was);
  }

  // Where the wrist is depends on the forearm, where the hand is from there on the hand.
  void place_hand(Bone& bone, const Bone& was) const {
    const double from_wrist = -wrist_of(was);
    bone.position[0] = was.position[0] * girths_.hand;
    bone.position[1] = was.position[1] * girths_.hand;
    bone.position[2] = was.position[2] * lengths_.forearm + from_wrist * (lengths_.hand - lengths_.forearm);
  }

  static double wrist_of(const Bone& hand) {
    double lowest = 0;
    for (const Joint& joint : hand.joints) lowest = std::min(lowest, joint.position[2]);
    return lowest;
  }

  // The leg ends on the ground. A foot is not as much thinner as the leg's closure would make it.
  void place_foot(Bone& bone, const Bone& was) const {
    const double sole = sole_height(base_);
    bone.position[2] = was.position[2] * lengths_.shank - sole * (lengths_.sole - lengths_.foot_breadth);
  }

  const Skeleton& base_;
  const Lengths& lengths_;
  const Girths& girths_;
};

// A part's mass over its volume's at the density of 18 months, by months.

// A head of a quarter of the mass at birth (textbooks; a ball has neither neck nor jaw), which fades into the 18-month
// body's sixth.
double head(double age) {
  constexpr Curve kFactor({0, 1, 2, 3, 6, 9, 12, 15, 18, 24}, {1.226, 1.235, 1.24, 1.24, 1.2, 1.13, 1.07, 1.025, 1, 1});
  return kFactor(age);
}

// Thighs and feet of Sun and Jensen (1994) up to half a year. Later they are held back: no part gets lighter, and the
// 18-month body has lighter ones than their infants of 15 months. Thighs of a year lie between theirs and those of
// Schneider and Zernicke (1992), who disagree by 30 %. Shanks agree with them by volume.
double thigh(double age) {
  constexpr Curve kFactor({0, 3, 6, 9, 12, 15, 18, 24}, {1, 1, 1.03, 1.08, 1.11, 1.06, 1, 1});
  return kFactor(age);
}

double foot(double age) {
  constexpr Curve kFactor({0, 1, 3, 6, 9, 12, 15, 18, 24}, {1.9, 1.72, 1.555, 1.45, 1.32, 1.19, 1.08, 1, 1});
  return kFactor(age);
}

// How a trunk's mass is spread was not found measured. Estimated, so that the whole body's centre of mass falls with
// age, as a share of the stature: the chest's factor, and the hip's over the belly's. The belly closes the sum.
double chest(double age) {
  constexpr Curve kFactor({0, 1, 2, 3, 6, 9, 12, 15, 18, 21, 24},
                          {0.935, 0.968, 1.057, 1.083, 1.085, 1.108, 1.095, 1.048, 1, 0.959, 0.923});
  return kFactor(age);
}

double hip_over_belly(double age) {
  constexpr Curve kRatio({0, 0.5, 1, 1.5, 2, 3, 4.5, 6, 7.5, 9, 10.5, 12, 13.5, 15, 16.5, 18, 21, 24},
                         {1.216, 1.218, 1.158, 1.079, 1.062, 1.08, 0.949, 0.837, 0.858, 0.845, 0.771, 0.723, 0.718,
                          0.744, 0.894, 1, 1.192, 1.372});
  return kRatio(age);
}

bool is_lower_trunk(const Bone& bone) { return bone.name == "hip" || bone.name == "lower_body"; }

class Spread {
 public:
  Spread(const Skeleton& body, double age)
      : head_(head(age)), chest_(chest(age)), thigh_(thigh(age)), foot_(foot(age)), hip_(hip_over_belly(age)) {
    double left = 0, weighed = 0;  // of the lower trunk: what it will weigh, and what that is over its factor
    for (const Bone& bone : body.bones) {
      for (const Geom& geom : bone.geoms) {
        left += is_lower_trunk(bone) ? geom.mass : (1 - factor(bone)) * geom.mass;
        weighed += is_lower_trunk(bone) ? factor(bone) * geom.mass : 0;
      }
    }
    require(left > 0, "no infant has a head of {:.2f} kg and weighs {:.2f} kg: z_head and z_weight do not go together",
            head_ * geom(body, "head").mass, total_mass(body));
    belly_ = left / weighed;
  }

  double factor(const Bone& bone) const {
    if (is_lower_trunk(bone)) return belly_ * (bone.name == "hip" ? hip_ : 1);
    switch (segment_of(bone.name)) {
      case Segment::kHead: return bone.name == "head" ? head_ : 1;
      case Segment::kTrunk: return chest_;
      case Segment::kThigh: return thigh_;
      case Segment::kFoot: return foot_;
      default: return 1;
    }
  }

 private:
  double head_, chest_, thigh_, foot_, hip_;
  double belly_ = 1;
};

constexpr double kLeast = 0.85, kMost = 1.15;
constexpr double kCm = 0.01;

// Factor that makes the base as long as the WHO's infants of 18 months.
double stretch_to_who(const Skeleton& base) { return length_at_18_months() * kCm / stature(base); }

class Fitter {
 public:
  Fitter(const Skeleton& base, const Growth& growth)
      : base_(base),
        drivers_(drivers(growth)),
        lengths_(lengths(base, drivers_, growth.age, growth.absolute ? stretch_to_who(base) : 1)),
        mass_(growth.absolute ? drivers_.weight : total_mass(base) * drivers_.mass) {}

  Fit fit() const {
    if (mass_of(1) == mass_) return {1, body(1)};
    double low = kLeast, high = kMost;
    require(mass_of(low) <= mass_ && mass_of(high) >= mass_,
            "no infant of {:.1f} cm with a head of {:.1f} cm weighs {:.2f} kg: z_length, z_weight and z_head do not go "
            "together; expected {:.2f} to {:.2f} kg",
            drivers_.length, drivers_.head, drivers_.weight, weight_of(low), weight_of(high));
    constexpr int kHalvings = 55;  // down to the last bit
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (mass_of(middle) < mass_ ? low : high) = middle;
    }
    return checked({high, body(high)});
  }

 private:
  // A capsule that gets thicker than long has no room between its round ends.
  Fit checked(Fit fit) const {
    for (const Bone& bone : fit.skeleton.bones) {
      for (const Geom& geom : bone.geoms) {
        require(geom.shape != GeomShape::kCapsule || geom.size[1] > 0,
                "no infant of {:.1f} cm weighs {:.2f} kg: z_length and z_weight do not go together, the capsule of its "
                "{} would be thicker than long",
                drivers_.length, drivers_.weight, bone.name);
      }
    }
    return fit;
  }

  Skeleton body(double closure) const { return resized(base_, lengths_, girths(drivers_, closure)); }
  double mass_of(double closure) const { return total_mass(body(closure)); }
  // As the WHO's scales would show it.
  double weight_of(double closure) const { return drivers_.weight * mass_of(closure) / mass_; }

  const Skeleton& base_;
  Drivers drivers_;
  Lengths lengths_;
  double mass_;
};

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
  const double shift = stretch * l * (upper + lower) * (sitting_share(age) - sitting_share(kBaseAge));
  const double thigh = fixed::pow(l, kThigh), shank = fixed::pow(l, kShank), foot = fixed::pow(l, kFoot);
  const double closure = (stretch * l * lower - shift) / (was.thigh * thigh + was.shank * shank + was.sole * foot);
  return {stretch * l,
          drivers.h,
          (stretch * l * upper + shift - was.head * drivers.h) / (upper - was.head),
          stretch * fixed::pow(l, kUpperArm),
          stretch * fixed::pow(l, kForearm),
          stretch * fixed::pow(l, kHand),
          thigh * closure,
          shank * closure,
          foot * closure,
          stretch * foot,
          stretch * fixed::pow(l, kFootBreadth),
          closure};
}

Girths girths(const Drivers& drivers, double closure) {
  const auto girth = [&](double exponent) { return fixed::pow(drivers.w, exponent) * closure; };
  return {girth(kChest),        girth(kWaist),
          girth(kHip),          girth(kUpperArmGirth),
          girth(kForearmGirth), girth(kHandGirth),
          girth(kThighGirth),   girth(kCalfGirth),
          girth(kAnkleGirth),   fixed::pow(drivers.frame, kShoulder)};
}

Skeleton resized(const Skeleton& base, const Lengths& lengths, const Girths& girths) {
  Skeleton skeleton = base;
  const Resizer resizer(base, lengths, girths);
  for (Bone& bone : skeleton.bones) resizer.resize(bone);
  return skeleton;
}

void spread_mass(Skeleton& body, double age) {
  const std::map<std::string, Load> was = loads(body);
  const Spread spread(body, age);
  for (Bone& bone : body.bones) {
    const double factor = spread.factor(bone);
    for (Geom& geom : bone.geoms) geom.mass *= factor;
  }
  const std::map<std::string, Load> is = loads(body);
  for (Motor& motor : body.motors) {
    const double heavier = is.at(motor.joint).moment / was.at(motor.joint).moment;
    motor.gear *= heavier;
    motor.muscle[1] *= heavier;
    motor.muscle[2] *= heavier;
  }
}

Fit fit(const Skeleton& base, const Growth& growth) { return Fitter(base, growth).fit(); }

}  // namespace mimo::growth
