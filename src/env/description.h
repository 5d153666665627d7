// What a world, or attached senses, observe, act with and are rewarded for, as those see it who use them.
#pragma once

#include <vector>

#include "env/attached.h"
#include "env/world.h"

namespace mimo::env {

// In seconds after the end of a step.
struct Interval {
  double start, end;
};

struct Action {
  const char* name;
  const char* unit;
  std::size_t agent;
  double low, high;
};

struct RewardTerm {
  const char* name;
  std::size_t agent;
};

// Of what it describes, which outlives it.
struct Description {
  const observation::Layout& layout;
  std::vector<Interval> times;  // by field
  double period;                // seconds from one step to the next
  std::size_t agents;
  std::vector<Action> actions;
  std::vector<RewardTerm> terms;
};

Description describe(const World& world);
Description describe(const Attached& attached);

}  // namespace mimo::env
