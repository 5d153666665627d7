// A step of the batch: its options, what it means for one world, and what it reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "base/fail.h"
#include "base/span.h"
#include "blueprint/aging_world.h"
#include "mimo/batch.h"

namespace mimo::batch {

// The inner forms of mimo_batch_config and mimo_batch_results.

// Of the header.
enum class Autoreset : std::int32_t {
  kNone = MIMO_AUTORESET_NONE,
  kNextStep = MIMO_AUTORESET_NEXT_STEP,
  kSameStep = MIMO_AUTORESET_SAME_STEP,
};

struct Options {
  std::size_t worlds = 1;
  std::size_t threads = 1;  // 0: one for each core that this process may use
  Autoreset autoreset = Autoreset::kNone;
  bool restart_failed = false;
};

// Where the results of a step go; null for what is not wanted. World i has row i.
struct Output {
  std::uint8_t* blocks = nullptr;
  double* reward = nullptr;            // worlds x agents
  std::uint8_t* terminated = nullptr;  // worlds x agents
  std::uint8_t* truncated = nullptr;   // worlds x agents
  std::int32_t* outcome = nullptr;     // worlds x agents
  double* terms = nullptr;             // worlds x terms
  std::int32_t* status = nullptr;
  std::uint8_t* was_reset = nullptr;
  std::uint8_t* final_blocks = nullptr;
  std::uint8_t* final_written = nullptr;
};

// What became of a world in the last call that concerned it.

// On a cache line of its own: the threads of a batch write into those of neighbouring worlds at the same time.
struct alignas(64) Report {
  Status status = Status::kOk;
  std::string message;
  bool settled = false;  // it failed, and was or will be restarted as configured

  // Without the message where no memory is left for it.
  void note(Status what, const char* why) noexcept;
};

// What a step of the batch means for one world: act, or start anew where an episode has ended or the world has failed.

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
