// Where joints are, how they move and what pulls at them, and what the nerves of muscles and joints report.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "body/body.h"
#include "mimo/experimental/receptors.h"
#include "observation/sense.h"

namespace mimo::senses {

// What the nerves of muscles and joints tell: spindles, tendon organs, joint receptors. Every motor of a joint with a
// range stands for two muscles, whose lengths follow from the joint's angle, whatever moves it.

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

// Where the joints are, how fast they move, what pulls at them, and how near they are to their limits.

struct ProprioceptionOptions {
  // MIMO_PROPRIOCEPTION_ bits; the actuation says what is felt of commands and effort.
  std::uint32_t wanted = MIMO_PROPRIOCEPTION_POSITION | MIMO_PROPRIOCEPTION_VELOCITY | MIMO_PROPRIOCEPTION_TORQUE |
                         MIMO_PROPRIOCEPTION_LIMIT | MIMO_PROPRIOCEPTION_ACTUATION;
  double limit_threshold = 0.035;  // rad
};

// `commands` are what the agent feels of what its motors are told. The rest is for receptors of muscles: see there.
std::unique_ptr<observation::Sense> make_proprioception(const mjModel& model, const body::Body& body,
                                                        const ProprioceptionOptions& options,
                                                        std::vector<observation::Signal> commands, Pulls pulls,
                                                        std::shared_ptr<FusimotorDrives> drives, double tick);

}  // namespace mimo::senses
