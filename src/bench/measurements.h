// What mimo-bench measures: threads, the paper's figure 3, a step of the original as the unit of time, allocations.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/timed_worlds.h"
#include "programs/world.h"

namespace cli {

// What many worlds and threads give: throughput, and how it grows with the threads, beside that of bare physics.

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

class ThreadScaling {
 public:
  ThreadScaling(const WorldOptions& options, std::size_t steps, int worlds, int threads);
  void run();
  // The entries of the bench's result that are about many worlds.
  nlohmann::ordered_json result();

 private:
  void run_batch(BatchWorld& batch, const Actions& actions, StepTimes& times, bool counted);
  void run_bare(const Actions& actions);

  std::size_t steps_;
  std::size_t worlds_, threads_;
  BatchWorld with_threads_, with_one_;
  std::vector<std::unique_ptr<PhysicsWorld>> bare_;  // one per thread
  RandomActions actions_;
  StepTimes step_with_threads_, step_with_one_;  // of the whole batch
  StepTimes bare_with_threads_, bare_with_one_;  // of a turn
};

// mimo-bench --paper: the measurements of the paper's Fig. 3.

struct Figure3Options {
  WorldOptions world;  // vision and touch are those of the paper
  bool brief;          // one episode instead of sixty
  std::string csv;     // a file, or "" for none
};

// Measures, and prints the table.
void run_paper(const Figure3Options& options);

// The unit of time of the benchmarks: one bare physics step of the benchmark scene as the original solves it (dense
// Jacobian), on Debian's build of MuJoCo.

// Measured here where libmimo runs on Debian's MuJoCo, else in a child process that does. Where Debian's is not
// installed there are no samples.
class ReferenceStep {
 public:
  ReferenceStep(std::uint64_t seed, std::size_t room);
  ~ReferenceStep();

  void run(std::size_t steps);  // environment steps, with random actions
  void warm_up();
  const StepTimes& times() const { return times_; }

 private:
  class InThisProcess;
  class InChildProcess;

  std::unique_ptr<InThisProcess> here_;
  std::unique_ptr<InChildProcess> child_;
  StepTimes times_;
};

// What the child does, until its standard input ends.
void serve_reference(std::uint64_t seed);

// Counts the process's memory allocations between start() and stop(), on all threads.

class AllocationCounter {
 public:
  // False where the program cannot stand between its libraries and malloc: not glibc, or under a sanitizer.
  static bool countable();
  static void start();
  static void stop();
  static std::uint64_t counted();  // in all stretches so far
};

}  // namespace cli
