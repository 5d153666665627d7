// Whoever follows the steps of a world, as a recording does. Whatever goes wrong with it is its own affair: the world
// goes on.
#pragma once

#include <cstdint>

#include "base/span.h"

namespace mimo::env {

class World;

class StepObserver {
 public:
  virtual ~StepObserver() = default;
  // A step begins. Gives the block that is filled: the caller's, or where that is null one of its own, or null.
  virtual std::uint8_t* step_begins(const World& world, std::uint8_t* block) noexcept = 0;
  virtual void step_ends(World& world, Span<const float> actions, const std::uint8_t* block) noexcept = 0;
  virtual void step_failed() noexcept = 0;
  // Another world has taken the place of the one that is followed.
  virtual void goes_on_in(World& world) noexcept = 0;
  // The last moment in which it can be looked at.
  virtual void ends(const World& world) noexcept = 0;
};

}  // namespace mimo::env
