// How a program runs: it reads its command line, works, shows progress, and reports a failure in one line.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

#include "programs/text.h"

namespace cli {

// What commands throw; mimo::Exception is what the library does.

// A command cannot do what it was asked for; the text is the one line that the user gets.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& text) : std::runtime_error(one_line(text)) {}
};

}  // namespace cli

namespace CLI {

class App;

}  // namespace CLI

namespace cli {

// "mimo" or "mimo run": what messages begin with.
std::string command_name(const CLI::App& program);

// Calls `describe`, which adds options and commands to the program, parses the arguments, which runs the callbacks, and
// calls `check`. Returns the exit status: 0, 1 after a failure, 2 for a wrong command line.
int run_program(CLI::App& program, const std::function<void()>& describe, const std::function<void()>& check, int argc,
                char** argv);

// A progress bar on stderr, shown only when that is a terminal.

class Progress {
 public:
  explicit Progress(std::size_t total);
  ~Progress();  // wipes the bar
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_;
  bool visible_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
};

}  // namespace cli
