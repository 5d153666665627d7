// What a world, or attached senses, observe, act with and are rewarded for, as those see it who use them.
#pragma once

#include <string>
#include <vector>

#include "env/attached.h"
#include "env/world.h"

namespace mimo::env {

// In seconds after the end of a step.
struct Interval {
  double start, end;
};

struct Action {
  std::string name;
  const char* unit;
  std::size_t agent;
  double low, high;
};

struct RewardTerm {
  std::string name;
  std::size_t agent;
};

// It outlives what it describes: worlds of other models may come after.
struct Description {
  std::size_t block_bytes = 0;
  std::vector<observation::Field> fields;
  std::vector<SkinPtr> skins;   // of the fields' receptors
  std::vector<Interval> times;  // by field
  std::vector<observation::Lateness> delays;
  double period = 0;  // seconds from one step to the next
  std::size_t agents = 0;
  std::vector<Action> actions;
  std::vector<RewardTerm> terms;
};

Description describe(const World& world);
Description describe(const Attached& attached);

// Throws Status::kInvalidArgument, with the first difference, where blocks, actions or terms of the two are not alike:
// in anything but bounds and the places of receptors.
void check_alike(const Description& expected, const Description& other);
// The wider bounds of both, which are alike.
void widen(Description& description, const Description& other) noexcept;
// Bounds, receptors and times become those of the other, which is alike. Names and shapes stay where they are.
void adopt(Description& description, Description&& other) noexcept;

}  // namespace mimo::env
