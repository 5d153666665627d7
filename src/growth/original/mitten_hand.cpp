#include "growth/original/measures.h"
#include "growth/original/parts.h"

namespace mimo::growth::original {

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

}  // namespace mimo::growth::original
