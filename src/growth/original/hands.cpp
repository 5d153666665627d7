// The original's rules for hands, with and without fingers.
#include "growth/original/original.h"

namespace mimo::growth::original {
namespace {

// Half sizes of the palm's two boxes: under index, middle and ring finger, and what is left beside it.
struct Palm {
  double thick;
  double x;
  double z;
  double rest_x;
  double rest_z;
};

Palm palm_at(double age) {
  const double share = 0.01712 / half_at_18(Measure::kHandBreadth);
  const double breadth = half(Measure::kHandBreadth, age), thick = 0.00584 * hand_thickness(age);
  const double z = half(Measure::kHandLength, age) / 2 - thick;
  return {thick, breadth * share, z, breadth * (1 - share), z / 2};
}

// A capsule that stands on its bone.
void set_bone(Geom& geom, double radius, double half_length) {
  set(geom, {radius, half_length, 0}, {0, 0, half_length});
}

class Hand {
 public:
  Hand(const Parts& parts, const Side& side, double age)
      : parts_(parts), side_(side), age_(age), palm_(palm_at(age)), wide_(ratio(Measure::kHandBreadth, age)) {}

  void grow() const {
    grow_palm();
    grow_wrist();
    grow_finger("ff", 0.95, 0.90);
    grow_finger("mf", 1, 1);
    grow_finger("rf", 0.95, 0.90);
    grow_finger("lf", 0.91, 0.88);
    place_knuckles();
    grow_little_metacarpal();
    grow_thumb();
  }

 private:
  Geom& geom(const std::string& name) const { return parts_.geom(side_.prefix + name); }
  Bone& bone(const std::string& name) const { return parts_.bone(side_.prefix + name); }

  void grow_palm() const {
    const double breadth = half(Measure::kHandBreadth, age_);
    set(geom("hand1"), {palm_.x, palm_.thick, palm_.z}, {0, 0, 0});
    set(geom("hand2"), {palm_.rest_x, palm_.thick, palm_.rest_z}, {-breadth, 0, -(palm_.z - palm_.rest_z)});
    set(geom("hand3"), {palm_.thick, palm_.x - kGap, 0}, {0, 0, palm_.z});
    set(geom("hand4"), {palm_.thick, breadth - kGap, 0}, {-palm_.rest_x, 0, -palm_.z});
  }

  void grow_wrist() const {
    const Geom& forearm = geom("larm");
    const double x = 0.007 * wide_;
    bone("hand").position = {x, 0, (2 * forearm.size[0] + 2 * forearm.size[1]) * 0.11032 / 0.12};
    const std::string joint = "robot:" + side_.prefix + "hand";
    parts_.joint(joint + "1").position = {-x, 0, -0.6 * palm_.z};
    parts_.joint(joint + "2").position = {-x, 0, -0.8 * palm_.z};
    parts_.joint(joint + "3").position = {-x, 0, -palm_.z};
  }

  double knuckle_half(double length) const { return half(Measure::kHandLength, age_) / 2 * length / 2; }

  // How thick and long it is, over the middle finger.
  void grow_finger(const std::string& finger, double thickness, double length) const {
    const double radius = half(Measure::kMiddleFinger, age_) * thickness, knuckle = knuckle_half(length);
    const double tip = 0.95 * 0.95 * radius;
    set_bone(geom(finger + "knuckle1"), radius, knuckle);
    set_bone(geom(finger + "middle1"), 0.95 * radius, knuckle / 2);
    set_bone(geom(finger + "distal1"), tip, knuckle / 2 - tip / 2);
    bone(finger + "middle").position = {0, 0, 2 * knuckle};
    bone(finger + "distal").position = {0, 0, knuckle};
  }

  void place_knuckles() const {
    const double beside = palm_.x - geom("ffknuckle1").size[0] - kGap;
    bone("ffknuckle").position = {beside, 0, palm_.z};
    bone("mfknuckle").position = {0, 0, palm_.z};
    bone("rfknuckle").position = {-beside, 0, palm_.z};
  }

  void grow_little_metacarpal() const {
    const double x = -0.01498 * wide_, z = 0.0031 * wide_;
    const double half_x = palm_.rest_x * 0.00508 / 0.00588, thick = palm_.thick + kGap;
    const double centre = -(palm_.x + 2 * palm_.rest_x - half_x + x + kGap);
    bone("lfmetacarpal").position = {x, 0, z};
    set(geom("lfmetacarpal1"), {half_x, thick, palm_.rest_z}, {centre, 0, -z});
    set(geom("lfmetacarpal2"), {thick, half_x - kGap, 0}, {centre, 0, palm_.rest_z - z});
    bone("lfknuckle").position = {-(x + palm_.x + palm_.rest_x * 0.00588 / 0.00508), 0, palm_.rest_z - z};
  }

  void grow_thumb() const {
    const double radius = half(Measure::kThumb, age_), base = 0.75 * knuckle_half(1);
    set_bone(geom("thbase1"), radius, base);
    set_bone(geom("thhub1"), 0.95 * radius, 0.7 * base);
    set_bone(geom("thdistal1"), 0.95 * 0.95 * radius, 0.65 * base);
    bone("thbase").position = {0.0123 * wide_, side_.left * 0.00423 / 0.00584 * palm_.thick,
                               -0.01602 * ratio(Measure::kHandLength, age_)};
    bone("thhub").position = {0, 0, 2 * base};
    bone("thdistal").position = {0, 0, 2 * 0.7 * base};
  }

  const Parts& parts_;
  const Side& side_;
  double age_;
  Palm palm_;
  double wide_;
};

}  // namespace

void grow_mitten_hand(const Parts& parts, const Side& side, double age) {
  const double thick = 0.01 * hand_thickness(age), breadth = half(Measure::kHandBreadth, age);
  const double fist = 0.0281 * ratio(Measure::kFistBreadth, age), length = ratio(Measure::kHandLength, age);
  const double palm = 0.0208 * length, fingers = 0.0207 * length;
  const Geom& forearm = parts.geom(side.prefix + "larm");
  parts.bone(side.prefix + "hand").position = {0, 0, (forearm.size[0] + 2 * forearm.size[1]) * 0.087 / 0.097};
  parts.joint("robot:" + side.prefix + "hand1").position = {0, 0, 0};
  set(parts.geom(side.prefix + "hand1"), {fist, thick, palm}, {thick / 2, 0, palm});
  set(parts.geom(side.prefix + "hand2"), {thick + 2 * kGap, fist, 0}, {thick / 2, 0, 2 * palm});
  parts.bone(side.prefix + "fingers").position = {0, 0, 2 * palm};
  set(parts.geom(side.prefix + "fingers1"), {breadth - 2 * kGap, thick, fingers}, {0, 0, fingers});
  set(parts.geom(side.prefix + "fingers2"), {thick + 2 * kGap, breadth, 0}, {0, 0, 2 * fingers});
}

void grow_fingered_hand(const Parts& parts, const Side& side, double age) { Hand(parts, side, age).grow(); }

}  // namespace mimo::growth::original
