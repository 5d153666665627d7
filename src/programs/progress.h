// A progress bar on stderr, shown only when that is a terminal.
#pragma once

#include <chrono>
#include <cstddef>

namespace cli {

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
