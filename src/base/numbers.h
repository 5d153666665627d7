// Small helpers for numbers: angles, lengths, bits of the header, delays in steps.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/fail.h"

namespace mimo {

// Angles.

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;  // in radians

// The length of what has these parts. Not std::hypot, whose last digit differs between releases of the C library, and
// with it pictures and senses; nothing here is so large or so small that its square is not a number.

template <typename Real>
Real length_of(Real x, Real y) {
  return std::sqrt(x * x + y * y);
}

template <typename Real>
Real length_of(Real x, Real y, Real z) {
  return std::sqrt(x * x + y * y + z * z);
}

// Bits of the header that say what of something is wanted.

// Whether one of some bits is there.
constexpr bool has_bit(std::uint32_t bits, std::uint32_t some) { return (bits & some) != 0; }

// The bits of all rows of a table.
template <typename Table>
constexpr std::uint32_t bits_of(const Table& table) {
  std::uint32_t all = 0;
  for (const auto& row : table) all |= row.bit;
  return all;
}

// Delays are given in seconds; delay lines count steps.

// The nearest number of steps, each of `step` seconds.
inline std::size_t steps_of_delay(double seconds, double step) {
  constexpr double kMost = 2000;
  const double steps = std::round(seconds / step);
  require(steps >= 0 && steps <= kMost, "delay is {} s, which is {} steps of {} s, expected 0 to {} steps", seconds,
          steps, step, kMost);
  return static_cast<std::size_t>(steps);
}

}  // namespace mimo
