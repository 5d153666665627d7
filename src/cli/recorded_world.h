// The options of a recorded world: kept in the recording as they were given, and read from there again.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "world.h"

namespace cli {

// Those of a world that moves, without the seed.
void add_recorded_options(CLI::App& command, WorldOptions& options);

// What was given of them, as JSON: {"scene": "benchmark", ...}.
std::string configuration_of(const CLI::App& command);

// A configuration, changed by what `changes` (a command with some of the same options) was given; and the options of
// one. Both throw a Failure that names the file for what no such configuration is.
std::string changed_configuration(const std::string& file, const std::string& configuration, const CLI::App& changes);
WorldOptions read_configuration(const std::string& file, const std::string& configuration);

// Options of replay that are also options of the recorded world.
void add_sense_options(CLI::App& command, WorldOptions& options);
bool senses_changed(const CLI::App& command);

}  // namespace cli
