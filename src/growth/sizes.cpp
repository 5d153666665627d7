#include "growth/sizes.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "growth/parts.h"
#include "growth/segments.h"
#include "growth/solids.h"

namespace mimo::growth {
namespace {

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
    } else if (segment == Segment::kHand && geom.shape == Shape::kCapsule) {
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
    fail(Status::kUnsupported, "the infant's trunk has a geom \"{}\", and growth knows none of that name", geom);
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
    if (geom.shape == Shape::kBox) {
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

}  // namespace

Skeleton resized(const Skeleton& base, const Lengths& lengths, const Girths& girths) {
  Skeleton skeleton = base;
  const Resizer resizer(base, lengths, girths);
  for (Bone& bone : skeleton.bones) resizer.resize(bone);
  return skeleton;
}

}  // namespace mimo::growth
