// Where the joints are, how fast they move, what pulls at them, and how near they are to their limits.
#pragma once

#include <memory>
#include <vector>

#include "body/body.h"
#include "observation/signals.h"
#include "senses/muscle_receptors.h"

namespace mimo::senses {

struct ProprioceptionOptions {
  bool position = true;
  bool velocity = true;
  bool torque = true;  // three axes at each joint sensor
  bool limit = true;
  bool joint_torque = false;       // about each joint's own axis
  double limit_threshold = 0.035;  // rad
  MuscleReceptorOptions receptors{};

  bool any() const { return position || velocity || torque || limit || joint_torque || receptors.any(); }
};

// `commands` are what the agent feels of what its motors are told. The rest is for receptors of muscles: see there.
std::unique_ptr<observation::Sense> make_proprioception(const mjModel& model, const body::Body& body,
                                                        const ProprioceptionOptions& options,
                                                        std::vector<observation::Signal> commands, Pulls pulls,
                                                        double tick);

}  // namespace mimo::senses
