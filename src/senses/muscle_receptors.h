// What the nerves of muscles and joints tell: spindles, tendon organs, joint receptors. Every motor of a joint with a
// range stands for two muscles, whose lengths follow from the joint's angle, whatever moves it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "body/body.h"
#include "observation/process.h"
#include "observation/signals.h"

namespace mimo::senses {

struct MuscleReceptorOptions {
  bool spindle_primary = false, spindle_secondary = false, tendon_organ = false, joint_receptor = false;
  bool any() const { return spindle_primary || spindle_secondary || tendon_organ || joint_receptor; }
};

// Of each muscle, first those that pull to the negative side, the share of its largest force; false: nothing else is
// known than the motors' forces.
using Pulls = std::function<bool(const mjData& data, double* shares)>;

struct MuscleReceptors {
  std::vector<observation::Signal> signals;
  std::unique_ptr<observation::Process> process;  // which they refer to; null without tendon organs
};

MuscleReceptors make_muscle_receptors(const mjModel& model, const body::Body& body,
                                      const MuscleReceptorOptions& options, double limit_threshold, Pulls pulls,
                                      double tick);

}  // namespace mimo::senses
