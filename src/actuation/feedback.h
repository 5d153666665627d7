// What an infant feels of its own commands.
#pragma once

#include <vector>

#include "body/body.h"
#include "observation/signals.h"

namespace mimo::actuation {

struct Feedback {
  std::vector<observation::Signal> commands;  // what its motors are told; a part of proprioception
  std::vector<observation::Signal> exertion;  // how its muscles work, and what that costs; after all other senses
};

// A field with one number for each of some actuators.
observation::Field actuator_field(const mjModel& model, const std::vector<int>& actuators, const char* name);

}  // namespace mimo::actuation
