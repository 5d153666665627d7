#include "growth/joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "growth/mechanics.h"
#include "growth/skeleton.h"
#include "growth/who.h"

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
  fail(Status::kUnsupported, "the infant has no geom \"{}\", so it cannot grow", name);
}

class Strength {
 public:
  Strength(const Skeleton& body, const Skeleton& base, const Growth& growth)
      : body_(body),
        base_(base),
        matured_(fixed::pow(median_length_ratio(growth.physiological_age), growth.strength_exponent)),
        neck_(growth.neck_strength * neck_ratio(growth.physiological_age) / neck_ratio(kBaseAge)) {}

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

enum Side : int { kLower = 0, kUpper = 1 };

struct LimitMark {
  double age;    // months
  double angle;  // degrees
};

// A limit that is another one in young infants, and the base's from an age on. Straight lines between the marks.
struct Limit {
  std::string_view joint;
  std::array<LimitMark, 4> marks;  // the first so many
  std::size_t count;
  double grown_out;  // months
  Side side;
  bool from_base;         // angles are to be added to the base's limit
  bool moves_the_spring;  // as far as the limit
};

// Knees: Broughton, Wright and Menelaus 1993, n = 57 (verified). Hips: Haas et al. 1973 for newborns (single copy) and
// Coon et al. 1975 at 6 weeks and 3 months (verified). Elbows: Shah et al. 2017 for newborns (verified), then
// estimated. Ankles of newborns: Waugh et al. 1983 (that the foot bends further up and less down is verified; how far,
// estimated).
constexpr Limit kLimits[] = {
    {"knee", {{{0, -21.4}, {3, -10.7}, {6, -3.3}}}, 3, 12, kUpper, false, true},
    {"hip1", {{{0, -30}, {1.4, -19}, {3, -7}, {9, 0}}}, 4, 12, kUpper, false, true},
    {"elbow", {{{0, -19}, {3, -7}}}, 2, 9, kUpper, false, true},
    {"foot1", {{{0, 30}}}, 1, 12, kUpper, true, false},
    {"foot1", {{{0, -25}}}, 1, 12, kLower, false, false},
};

double between(const LimitMark& a, const LimitMark& b, double age) {
  return a.angle + (b.angle - a.angle) * (age - a.age) / (b.age - a.age);
}

// In degrees, at an age before it is grown out.
double limit_at(const Limit& limit, double base, double age) {
  std::vector<LimitMark> marks(limit.marks.begin(), limit.marks.begin() + limit.count);
  for (LimitMark& mark : marks) mark.angle += limit.from_base ? base : 0;
  marks.push_back({limit.grown_out, base});
  const auto next = std::find_if(marks.begin() + 1, marks.end(), [&](const LimitMark& mark) { return age < mark.age; });
  return between(next[-1], next[0], age);
}

void apply(const Limit& limit, const Growth& growth, Joint& joint) {
  if (growth.physiological_age >= limit.grown_out) return;
  double& end = joint.range[limit.side];
  const double young = limit_at(limit, end / kDegree, growth.physiological_age) * kDegree;
  const double shift = growth.contracture * (young - end);
  end += shift;
  if (limit.moves_the_spring) joint.springref = std::max(joint.springref + shift, joint.range[kLower]);
}

constexpr double kToneFades = 6;  // months

// For the integrator's sake, at an unchanged time step.
constexpr double kLeastDamping = 0.02;
constexpr double kLeastArmature = 0.01;

double tone_at(const Growth& growth) {
  const double young = std::max(0.0, 1 - growth.physiological_age / kToneFades);
  return 1 + (growth.birth_tone - 1) * young;
}

// Hands of the 18-month body are not exactly each other's mirror images; what grows is the same on both sides.
std::string left_twin(const Joint& joint) {
  if (side_of(joint.name) != "right_") return joint.name;
  return "robot:left_" + std::string(plain_name(joint.name));
}

void set_tone(Joint& joint, const Load& is, const Load& was, double tone) {
  const double moment = is.moment / was.moment, inertia = is.inertia / was.inertia;
  const double stiffness = moment * tone;
  joint.stiffness *= stiffness;
  joint.frictionloss *= moment;
  joint.damping *= std::max(kLeastDamping, std::sqrt(stiffness * inertia));
  joint.armature *= std::max(kLeastArmature, inertia);
}

// The same geoms as in MIMo v2.
constexpr std::pair<std::string_view, std::string_view> kMuscles[] = {
    {"hip_bend", "cb"},
    {"hip_twist", "cb"},
    {"hip_lean", "cb"},
    {"head_swivel", "head"},
    {"head_tilt", "head"},
    {"head_tilt_side", "head"},
    {"eye_horizontal", "eye"},
    {"eye_vertical", "eye"},
    {"eye_torsional", "eye"},
    {"shoulder_horizontal", "uarm1"},
    {"shoulder_abduction", "uarm1"},
    {"shoulder_internal", "uarm1"},
    {"elbow", "larm"},
    {"wrist_rotation", "hand1"},
    {"wrist_flexion", "hand1"},
    {"wrist_ulnar", "hand1"},
    {"fingers", "hand1"},
    {"ff_side", "ffknuckle1"},
    {"ff_knuckle", "ffknuckle1"},
    {"ff_middle", "ffmiddle1"},
    {"ff_distal", "ffdistal1"},
    {"mf_side", "mfknuckle1"},
    {"mf_knuckle", "mfknuckle1"},
    {"mf_middle", "mfmiddle1"},
    {"mf_distal", "mfdistal1"},
    {"rf_side", "rfknuckle1"},
    {"rf_knuckle", "rfknuckle1"},
    {"rf_middle", "rfmiddle1"},
    {"rf_distal", "rfdistal1"},
    {"lf_meta", "lfmetacarpal1"},
    {"lf_side", "lfknuckle1"},
    {"lf_knuckle", "lfknuckle1"},
    {"lf_middle", "lfmiddle1"},
    {"lf_distal", "lfdistal1"},
    {"thumb_side", "thbase1"},
    {"thumb_add", "thbase1"},
    {"thumb_pivot", "thhub1"},
    {"thumb_middle", "thhub1"},
    {"thumb_distal", "thdistal1"},
    {"hip_flex", "upper_leg1"},
    {"hip_abduction", "upper_leg1"},
    {"hip_rotation", "upper_leg1"},
    {"knee", "lower_leg1"},
    {"foot_flexion", "foot2"},
    {"foot_inversion", "foot2"},
    {"foot_rotation", "foot2"},
    {"big_toe", "big_toe1"},
};

bool has_big_toe(const Skeleton& skeleton) {
  for (const Bone& bone : skeleton.bones) {
    if (plain_name(bone.name) == "big_toe") return true;
  }
  return false;
}

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

void limit(Skeleton& body, const Growth& growth) {
  for (Bone& bone : body.bones) {
    for (Joint& joint : bone.joints) {
      for (const Limit& limit : kLimits) {
        if (plain_name(joint.name) == limit.joint) apply(limit, growth, joint);
      }
    }
  }
}

void set_tone(Skeleton& body, const Skeleton& base, const Growth& growth) {
  const double tone = tone_at(growth);
  const std::map<std::string, Load> is = loads(body), was = loads(base);
  for (Bone& bone : body.bones) {
    for (Joint& joint : bone.joints) set_tone(joint, is.at(left_twin(joint)), was.at(left_twin(joint)), tone);
  }
}

std::string muscle_geom(const Skeleton& skeleton, const Motor& motor) {
  const std::string_view name = plain_name(motor.name);
  const std::string side = side_of(motor.name);
  // All toes of a mitten foot move as one.
  if (name == "toes") return side + (has_big_toe(skeleton) ? "toes1" : "foot2");
  const auto* found =
      std::find_if(std::begin(kMuscles), std::end(kMuscles), [&](auto& row) { return row.first == name; });
  if (found == std::end(kMuscles)) {
    fail(Status::kUnsupported, "the infant has a motor \"{}\", which growth does not know", motor.name);
  }
  return side + std::string(found->second);
}

bool moves_neck(const Motor& motor) { return begins_with(plain_name(motor.name), "head_"); }

bool moves_eye(const Motor& motor) { return begins_with(plain_name(motor.name), "eye_"); }

}  // namespace mimo::growth
