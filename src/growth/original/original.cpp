#include "growth/original/original.h"

#include "growth/muscles.h"
#include "growth/original/parts.h"
#include "growth/solids.h"

namespace mimo::growth {
namespace {

void grow_side(const Parts& parts, const original::Side& side, double age) {
  grow_arm(parts, side, age);
  if (parts.has_bone(side.prefix + "fingers")) {
    grow_mitten_hand(parts, side, age);
  } else {
    grow_fingered_hand(parts, side, age);
  }
  grow_leg(parts, side, age);
}

double volume_ratio(const Skeleton& body, const Skeleton& base, const std::string& name) {
  return volume(geom(body, name)) / volume(geom(base, name));
}

void set_masses(Skeleton& body, const Skeleton& base) {
  for (Bone& bone : body.bones) {
    for (Geom& geom : bone.geoms) geom.mass *= volume_ratio(body, base, geom.name);
  }
}

void set_gears(Skeleton& body, const Skeleton& base) {
  for (Motor& motor : body.motors) motor.gear *= volume_ratio(body, base, muscle_geom(base, motor));
}

}  // namespace

Skeleton grown_as_original(const Skeleton& base, double age) {
  Skeleton body = base;
  const Parts parts(body);
  original::grow_trunk(parts, age);
  original::grow_head(parts, age);
  grow_side(parts, {"left_", 1}, age);
  grow_side(parts, {"right_", -1}, age);
  set_masses(body, base);
  set_gears(body, base);
  return body;
}

}  // namespace mimo::growth
