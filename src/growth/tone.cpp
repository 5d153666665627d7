#include "growth/tone.h"

#include <algorithm>
#include <cmath>

#include "growth/load.h"

namespace mimo::growth {
namespace {

constexpr double kToneFades = 6;  // months

// For the integrator's sake, at an unchanged time step.
constexpr double kLeastDamping = 0.02;
constexpr double kLeastArmature = 0.01;

double tone_at(const Growth& growth) {
  const double young = std::max(0.0, 1 - growth.physiological_age / kToneFades);
  return 1 + (growth.birth_tone - 1) * young;
}

void set_tone(Joint& joint, const Load& is, const Load& was, double tone) {
  const double moment = is.moment / was.moment, inertia = is.inertia / was.inertia;
  const double stiffness = moment * tone;
  joint.stiffness *= stiffness;
  joint.frictionloss *= moment;
  joint.damping *= std::max(kLeastDamping, std::sqrt(stiffness * inertia));
  joint.armature *= std::max(kLeastArmature, inertia);
}

}  // namespace

void set_tone(Skeleton& body, const Skeleton& base, const Growth& growth) {
  const double tone = tone_at(growth);
  const std::vector<Load> is = loads(body), was = loads(base);
  std::size_t number = 0;
  for (Bone& bone : body.bones) {
    for (Joint& joint : bone.joints) {
      set_tone(joint, is[number], was[number], tone);
      ++number;
    }
  }
}

}  // namespace mimo::growth
