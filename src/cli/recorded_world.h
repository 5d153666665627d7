// Options of a recording, and the world that a replay makes of it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>

#include "programs/world.h"

namespace cli {

// How a recording is written, for the commands that write one.

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

// The options of a world that is recorded, and the world that a replay makes of the recording.

// Those of a world that moves, without the seed.
void add_recorded_options(CLI::App& command, WorldOptions& options);

// The world of a recording, whose senses are as recorded, except those for which `command` got options. The recording
// is given the senses of the user's own. A world of a version that kept none is made of the options alone. Throws a
// Failure that names the file, where options are given or missing for that.
mimo::Env open_recorded(const std::string& file, mimo::Recording& recording, const WorldOptions& options,
                        const CLI::App& command);

// Whether what is sensed may differ from what was recorded.
bool senses_changed(const CLI::App& command);

}  // namespace cli
