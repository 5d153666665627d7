// Where the time of steps went, and a stopwatch.
#pragma once

#include <chrono>
#include <mimo/mimo.hpp>
#include <string>
#include <utility>
#include <vector>

namespace cli {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Milliseconds a step: physics, touch, vision, proprioception, vestibular, hearing where somebody does, and `other`,
// which makes the sum equal to the given total.
std::vector<std::pair<std::string, double>> split_ms(const mimo_timing& timing, double total_ms);

}  // namespace cli
