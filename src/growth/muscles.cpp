#include "growth/muscles.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/fail.h"
#include "base/format.h"
#include "growth/parts.h"

namespace mimo::growth {
namespace {

// The same geoms as in MIMo v2.
constexpr std::pair<std::string_view, std::string_view> kTable[] = {
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

std::string muscle_geom(const Skeleton& skeleton, const Motor& motor) {
  const std::string_view name = plain_name(motor.name);
  const std::string side = side_of(motor.name);
  // All toes of a mitten foot move as one.
  if (name == "toes") return side + (has_big_toe(skeleton) ? "toes1" : "foot2");
  const auto* found = std::find_if(std::begin(kTable), std::end(kTable), [&](auto& row) { return row.first == name; });
  if (found == std::end(kTable)) {
    fail(Status::kUnsupported, "the infant has a motor \"{}\", and growth knows none of that name", motor.name);
  }
  return side + std::string(found->second);
}

bool moves_neck(const Motor& motor) { return begins_with(plain_name(motor.name), "head_"); }

bool moves_eye(const Motor& motor) { return begins_with(plain_name(motor.name), "eye_"); }

}  // namespace mimo::growth
