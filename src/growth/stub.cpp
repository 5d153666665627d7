// Until the real one is merged.
#include "base/fail.h"
#include "growth/grow.h"
#include "growth/kinematics.h"
#include "growth/measures.h"
namespace mimo::growth {
void check(const Growth&) {}
Skeleton grown(const Skeleton& base, const Growth& growth) {
  const double f = growth.age / 18;
  if (growth.age == 18) return base;
  Skeleton changed = base;
  for (Bone& bone : changed.bones) {
    if (bone.parent >= 0) for (double& x : bone.position) x *= f;
    for (Geom& geom : bone.geoms) {
      for (double& x : geom.size) x *= f;
      for (double& x : geom.position) x *= f;
      geom.mass *= f * f * f;
    }
    for (Joint& joint : bone.joints) for (double& x : joint.position) x *= f;
    for (Mark& mark : bone.marks) for (double& x : mark.position) x *= f;
  }
  return changed;
}
double lowest_point(const Skeleton& s, const std::map<std::string, double>&) { return s.bones.back().position[2]; }
double stature(const Skeleton& s) { return s.bones.back().position[2]; }
}  // namespace mimo::growth
