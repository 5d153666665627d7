// Comparing numbers with known ones.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace mimo::test {

// Recorded numbers: nine digits, and what is as good as zero counts as zero.
constexpr double kRelative = 1e-9;
constexpr double kFloor = 1e-12;

struct Tolerance {
  double relative = kRelative;
  double floor = kFloor;
  bool admits(double expected, double actual) const {
    return std::abs(actual - expected) <= std::max(floor, relative * std::abs(expected));  // false for NaN
  }
};

inline ::testing::AssertionResult close(double expected, double actual, const Tolerance& tolerance = {}) {
  if (tolerance.admits(expected, actual)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << actual << " differs from the expected " << expected << " by "
                                       << actual - expected;
}

inline ::testing::AssertionResult close(const std::vector<double>& expected, const double* actual,
                                        const Tolerance& tolerance = {}) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const ::testing::AssertionResult result = close(expected[i], actual[i], tolerance);
    if (!result) return ::testing::AssertionFailure() << "element " << i << ": " << result.message();
  }
  return ::testing::AssertionSuccess();
}

// q and -q are the same rotation.
inline ::testing::AssertionResult same_rotation(std::vector<double> expected, const double* actual,
                                                const Tolerance& tolerance = {}) {
  double dot = 0;
  for (std::size_t i = 0; i < 4; ++i) dot += expected[i] * actual[i];
  if (dot < 0) {
    for (double& value : expected) value = -value;
  }
  return close(expected, actual, tolerance);
}

// Every number of one array, to the last bit.
inline std::vector<double> copy(const double* from, int count) { return std::vector<double>(from, from + count); }

}  // namespace mimo::test
