#include "growth/measures.h"

#include "growth/closure.h"
#include "growth/drivers.h"
#include "growth/grow.h"
#include "growth/kinematics.h"
#include "growth/parts.h"

namespace mimo::growth {
namespace {

// The root as it stands in the scene has no say in it.
Skeleton upright(Skeleton skeleton) {
  skeleton.bones.front().position = {0, 0, 0};
  skeleton.bones.front().orientation = {1, 0, 0, 0};
  return skeleton;
}

}  // namespace

double stature(const Skeleton& skeleton) {
  const Skeleton standing = upright(skeleton);
  return highest_point(standing, {}) - lowest_point(standing, {});
}

Measures measures(const Skeleton& base, const Growth& growth) {
  check(growth);
  const Drivers who = drivers(growth);
  const double closure = growth.model == Model::kWho ? fit(base, growth).closure : 1;
  const Skeleton body = grown(base, growth);
  return {who.length, who.weight, who.head, who.l, who.w, who.h, closure, stature(body), total_mass(body)};
}

}  // namespace mimo::growth
