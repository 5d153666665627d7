// The options of a recorded world: kept in the recording as they were given, and read from there again.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "programs/world.h"

namespace cli {

// Those of a world that moves, without the seed.
void add_recorded_options(CLI::App& command, WorldOptions& options);

// What was given of them, as JSON: {"scene": "benchmark", ...}.
std::string configuration_of(const CLI::App& command);

// Whether a configuration is one that this program wrote.
bool is_ours(const std::string& configuration);

// A configuration, changed by what `changes` (a command with some of the same options) was given; and the options of
// one. That of another program counts as empty: the changes then
// have to name the scene, and else may not touch what is acted in. Both throw a Failure that
// names the file.
std::string changed_configuration(const std::string& file, const std::string& configuration, const CLI::App& changes);
WorldOptions read_configuration(const std::string& file, const std::string& configuration);

// What they consist of: the world that is acted in, and what is sensed, which a replay may change.
void add_acting_options(CLI::App& command, WorldOptions& options);
void add_sense_options(CLI::App& command, WorldOptions& options);
bool senses_changed(const CLI::App& command);

}  // namespace cli
