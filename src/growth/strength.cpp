#include "growth/strength.h"

#include <cmath>

#include "base/fail.h"
#include "growth/curve.h"
#include "growth/drivers.h"
#include "growth/muscles.h"
#include "growth/parts.h"
#include "growth/segments.h"
#include "growth/solids.h"

namespace mimo::growth {
namespace {

// What goes with the volume of the muscles in a geom: cross-section times length, of limbs without the round ends.
double bulk(const Skeleton& skeleton, const std::string& name) {
  for (const Bone& bone : skeleton.bones) {
    for (const Geom& geom : bone.geoms) {
      if (geom.name != name) continue;
      return is_limb(segment_of(bone.name)) ? geom.size[0] * geom.size[0] * geom.size[1] : volume(geom);
    }
  }
  fail(Status::kUnsupported, "the infant has no geom \"{}\", so it is none that grows", name);
}

class Strength {
 public:
  Strength(const Skeleton& body, const Skeleton& base, const Growth& growth)
      : body_(body),
        base_(base),
        matured_(std::pow(median_length_ratio(growth.physiological_age), growth.strength_exponent)),
        neck_(growth.neck_strength * neck_ratio(growth.physiological_age) / neck_ratio(kBase)) {}

  // The torque's ratio to the base's.
  double ratio(const Motor& motor) const {
    // Torque over the moment of the head's weight is what holds a head.
    if (moves_neck(motor)) return neck_ * head_moment(body_) / head_moment(base_);
    const double grown = muscle_ratio(motor);
    // An eye weighs nothing, and newborns move theirs as they can.
    return moves_eye(motor) ? grown : grown * matured_;
  }

 private:
  double muscle_ratio(const Motor& motor) const {
    const std::string name = muscle_geom(base_, motor);
    return bulk(body_, name) / bulk(base_, name);
  }

  // The lever is the distance of the head's centre from the axis that tilts it.
  static double head_moment(const Skeleton& skeleton) {
    const Geom& head = geom(skeleton, "head");
    double hinge = 0;
    for (const Joint& joint : bone(skeleton, "head").joints) {
      if (plain_name(joint.name) == "head_tilt") hinge = joint.position[2];
    }
    return head.mass * (head.position[2] - hinge);
  }

  const Skeleton& body_;
  const Skeleton& base_;
  double matured_;
  double neck_;
};

}  // namespace

// From head lag, which is there before 3 months and gone at 4, and from the head held in line at 2.
double neck_ratio(double age) {
  constexpr Curve kRatio({0, 1, 2, 3, 4, 6, 9, 12, 18, 24}, {0.5, 0.75, 1.0, 1.3, 1.5, 2.0, 2.5, 2.8, 3.04, 3.1});
  return kRatio(age);
}

void strengthen(Skeleton& body, const Skeleton& base, const Growth& growth) {
  const Strength strength(body, base, growth);
  for (Motor& motor : body.motors) {
    const double ratio = strength.ratio(motor);
    motor.gear *= ratio;
    motor.muscle[1] *= ratio;
    motor.muscle[2] *= ratio;
  }
}

}  // namespace mimo::growth
