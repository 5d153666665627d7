// How a program runs: it reads its command line, works, and reports a failure in one line.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace cli {

// "mimo" or "mimo run": what messages begin with.
std::string command_name(const CLI::App& program);

// Calls `describe`, which adds options and commands to the program, parses the arguments, which runs the callbacks, and
// calls `check`. Returns the exit status: 0, 1 after a failure, 2 for a wrong command line.
int run_program(CLI::App& program, const std::function<void()>& describe, const std::function<void()>& check, int argc,
                char** argv);

}  // namespace cli
