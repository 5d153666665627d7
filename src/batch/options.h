// The inner forms of mimo_batch_config and mimo_batch_results.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/status.h"
#include "mimo/batch.h"

namespace mimo::batch {

// Of the header.
enum class Autoreset : std::int32_t {
  kNone = MIMO_AUTORESET_NONE,
  kNextStep = MIMO_AUTORESET_NEXT_STEP,
  kSameStep = MIMO_AUTORESET_SAME_STEP,
};

struct Options {
  std::size_t worlds = 1;
  std::size_t threads = 1;  // 0: as many as the machine has
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

}  // namespace mimo::batch
