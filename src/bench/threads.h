// What many worlds and threads give: throughput, and how it grows with the threads, beside that of bare physics.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "bench/physics.h"

namespace cli {

// A batch of worlds, stepped with random actions. All worlds get the same ones; their seeds differ.
class BatchWorld {
 public:
  BatchWorld(const WorldOptions& options, int worlds, int threads);

  void step(const std::vector<float>& action);  // of one world
  void forget_times();
  // Where the time of a world's step goes, ms, from the worlds' own clocks.
  double ms_per_step();
  nlohmann::ordered_json split();

 private:
  mimo_timing timing();  // of all worlds together

  mimo::Batch batch_;
  std::size_t worlds_;
  mimo::Block blocks_;
  std::vector<float> actions_;
};

class Scaling {
 public:
  Scaling(const WorldOptions& options, std::size_t steps, int worlds, int threads);
  void run();
  // The entries of the bench's result that are about many worlds.
  nlohmann::ordered_json result();

 private:
  void run_batch(BatchWorld& batch, const Actions& actions, Samples& times, bool counted);
  void run_bare(const Actions& actions);

  std::size_t steps_;
  std::size_t worlds_, threads_;
  BatchWorld with_threads_, with_one_;
  std::vector<std::unique_ptr<BareWorld>> bare_;  // one per thread
  RandomActions actions_;
  Samples step_with_threads_, step_with_one_;  // of the whole batch
  Samples bare_with_threads_, bare_with_one_;  // of a turn
};

}  // namespace cli
