#include "growth/tone.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "growth/load.h"
#include "growth/parts.h"

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

}  // namespace

void set_tone(Skeleton& body, const Skeleton& base, const Growth& growth) {
  const double tone = tone_at(growth);
  const std::map<std::string, Load> is = loads(body), was = loads(base);
  for (Bone& bone : body.bones) {
    for (Joint& joint : bone.joints) set_tone(joint, is.at(left_twin(joint)), was.at(left_twin(joint)), tone);
  }
}

}  // namespace mimo::growth
