// What a step gave beside the observation, in room of its own.
#pragma once

#include <vector>

#include "env/world.h"

namespace mimo::recording {

struct StepResults {
  std::vector<double> reward, terms;
  std::vector<std::uint8_t> terminated, truncated;
  std::vector<std::int32_t> outcome;

  // Of the world's last step.
  void take(const env::World& world) {
    const std::size_t agents = world.agents().size();
    reward.resize(agents);
    terminated.resize(agents);
    truncated.resize(agents);
    outcome.resize(agents);
    terms.resize(world.term_count());
    world.report({reward, terminated, truncated, outcome, terms});
  }
};

}  // namespace mimo::recording
