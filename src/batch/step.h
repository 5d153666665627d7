// What a step of the batch means for one world: act, or start anew where an episode has ended or the world has failed.
#pragma once

#include <memory>

#include "base/span.h"
#include "batch/options.h"
#include "batch/report.h"
#include "blueprint/aging_world.h"

namespace mimo::batch {

using Worlds = Span<const std::unique_ptr<blueprint::AgingWorld>>;

// A world's own among blocks that may be null.
inline std::uint8_t* block_of(Worlds worlds, std::uint8_t* blocks, std::size_t world) {
  return blocks == nullptr ? nullptr : blocks + world * worlds[world]->world().layout().bytes();
}

class Step {
 public:
  // All of it outlives the step; so do the caller's actions, which may be null, and what the output points to.
  Step(Worlds worlds, const Options& options, const float* actions, const Output& output)
      : worlds_(worlds), options_(options), actions_(actions), output_(output) {}

  // In the report a failure is settled that is followed by a restart.
  void operator()(std::size_t world, Report& report) const;

 private:
  env::World& at(std::size_t world) const { return worlds_[world]->world(); }
  bool due_for_reset(std::size_t world) const;
  void act(std::size_t world, Span<const float> actions, Report& report) const;
  void end_episode(std::size_t world) const;
  void restart(std::size_t world) const;
  void blank(std::size_t world, bool cut_off) const;
  Span<const float> actions_of(std::size_t world) const;
  env::Results results_of(std::size_t world) const;
  std::uint8_t* block(std::size_t world) const { return block_of(worlds_, output_.blocks, world); }

  Worlds worlds_;
  const Options& options_;
  const float* actions_;
  Output output_;
};

}  // namespace mimo::batch
