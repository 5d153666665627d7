// Delays are seconds; whoever keeps what is on its way counts steps.
#pragma once

#include <cmath>

#include "base/fail.h"

namespace mimo {

// The nearest number of steps, each of `step` seconds.
inline std::size_t steps_of_delay(double seconds, double step) {
  constexpr double kMost = 2000;
  const double steps = std::round(seconds / step);
  require(steps >= 0 && steps <= kMost, "delay is {} s, which is {} steps of {} s, expected 0 to {} steps", seconds,
          steps, step, kMost);
  return static_cast<std::size_t>(steps);
}

}  // namespace mimo
