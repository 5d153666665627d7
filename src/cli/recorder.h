// Writes a run into a recording: what was done, what came of it, and states to go on from.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

#include "recording_file.h"
#include "timing.h"

namespace cli {

struct RecorderOptions {
  std::string out;
  std::string keep = "proprioception,vestibular";  // fields, or senses; "none", "all"
  double state_every = 1;                          // s of simulated time between kept states
  double flush_every = 1;                          // s of real time
  unsigned compression = 4;                        // 0 to 9
};

// What made the numbers: versions, and which build of libmimo.
std::string build_name();

std::string joint_names(const mimo::Env& env);     // a line each
std::string field_table(const mimo_field& field);  // what a field is called in the file

// What the columns of joints mean, and the two tables that every recording compares with.
constexpr char kJointPosition[] = "joints/position", kJointVelocity[] = "joints/velocity", kActions[] = "actions",
               kRewards[] = "rewards", kTime[] = "time", kStates[] = "states/state", kStateSteps[] = "states/step";

class Recorder {
 public:
  // Throws before the file is made where `keep` fits nothing.
  Recorder(const RecorderOptions& options, const mimo::Env& env, const std::string& configuration, std::uint64_t seed);

  void before_step(const mimo::Env& env);  // keeps a state when it is time
  void after_step(const mimo::Env& env, const std::vector<float>& actions, const mimo::Block& block,
                  const mimo::Results& results);
  void finish(const mimo::Env& env);  // the last state, and the file is closed

 private:
  void describe(const mimo::Env& env, const std::string& configuration, std::uint64_t seed);
  void keep_state(const mimo::Env& env);

  double step_seconds_;
  std::size_t state_every_;  // steps
  double flush_every_;
  std::vector<mimo_field> fields_;
  std::vector<std::int32_t> joints_;
  RecordingWriter file_;
  std::int64_t steps_ = 0;
  Clock::time_point flushed_ = Clock::now();
};

}  // namespace cli
