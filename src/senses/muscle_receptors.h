// What the nerves of muscles and joints tell: spindles, tendon organs, joint receptors. Every motor of a joint with a
// range stands for two muscles, whose lengths follow from the joint's angle, whatever moves it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/bits.h"
#include "body/body.h"
#include "mimo/experimental/receptors.h"
#include "observation/process.h"
#include "observation/signals.h"

namespace mimo::senses {

class FusimotorDrives;

// Of MIMO_PROPRIOCEPTION_, those of spindles, and all of receptors.
constexpr std::uint32_t kSpindles = MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY | MIMO_PROPRIOCEPTION_SPINDLE_SECONDARY;
constexpr std::uint32_t kMuscleReceptors =
    kSpindles | MIMO_PROPRIOCEPTION_TENDON_ORGAN | MIMO_PROPRIOCEPTION_JOINT_RECEPTOR;

// Of each muscle, first those that pull to the negative side, the share of its largest force; false: nothing else is
// known than the motors' forces.
using Pulls = std::function<bool(const mjData& data, double* shares)>;

struct MuscleReceptors {
  std::vector<observation::Signal> signals;
  std::vector<std::unique_ptr<observation::Process>> processes;  // which they refer to
};

// Of the motors that have spindles.
std::shared_ptr<FusimotorDrives> make_fusimotor_drives(const mjModel& model, const body::Body& body);

MuscleReceptors make_muscle_receptors(const mjModel& model, const body::Body& body, std::uint32_t wanted,
                                      double limit_threshold, Pulls pulls, std::shared_ptr<FusimotorDrives> drives,
                                      double tick);

}  // namespace mimo::senses
