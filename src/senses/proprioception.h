// Where the joints are, how fast they move, what pulls at them, and how near they are to their limits.
#pragma once

#include <memory>
#include <vector>

#include "body/body.h"
#include "observation/signals.h"
#include "senses/muscle_receptors.h"

namespace mimo::senses {

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
