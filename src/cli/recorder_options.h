// How a recording is written, for the commands that write one.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>

namespace cli {

struct RecorderOptions {
  std::string out;
  std::string keep = "proprioception,vestibular";
  double state_every = 1;  // s of simulated time between kept states
  double flush_every = 1;  // s of real time
  unsigned compression = 4;
  bool replace = false;  // a recording that is there
};

CLI::Option* add_recorder_options(CLI::App& command, RecorderOptions& options);  // returns that of the file

mimo::Recorder open_recorder(mimo::Env& env, const RecorderOptions& options, std::uint64_t seed);

}  // namespace cli
