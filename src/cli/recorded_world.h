// The options of a world that is recorded, and the world that a replay makes of the recording.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "programs/world.h"

namespace cli {

// Those of a world that moves, without the seed.
void add_recorded_options(CLI::App& command, WorldOptions& options);

// The world of a recording, whose senses are as recorded but for those that `command` was given options of. One of a
// version that kept no world is made of the options alone. Throws a Failure that names the file, where options are
// given or missing for that.
mimo::Env open_recorded(const std::string& file, const mimo::Recording& recording, const WorldOptions& options,
                        const CLI::App& command);

// Whether what is sensed may differ from what was recorded.
bool senses_changed(const CLI::App& command);

}  // namespace cli
