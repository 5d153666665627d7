// How a recording is written, for the commands that write one.
#pragma once

#include <CLI/CLI.hpp>

#include "recorder.h"

namespace cli {

CLI::Option* add_recorder_options(CLI::App& command, RecorderOptions& options);  // returns that of the file

}  // namespace cli
