#include "base/functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

namespace mimo {
namespace {

constexpr double kDigit = 4 * std::numeric_limits<double>::epsilon();  // two to four last digits

TEST(Functions, AreThoseOfTheirNames) {
  EXPECT_NEAR(cube_root(27), 3, 3 * kDigit);
  EXPECT_NEAR(cube_root(1e-9), 1e-3, 1e-3 * kDigit);
  EXPECT_EQ(cube_root(0), 0);
  EXPECT_NEAR(two_to(-0.5), std::sqrt(0.5), kDigit);
  EXPECT_NEAR(log_10(1e-5), -5, 5 * kDigit);
  const std::complex<double> fifth = quotient({1, 2}, {3, -4});  // (1 + 2i)(3 + 4i) / 25
  EXPECT_NEAR(fifth.real(), -0.2, kDigit);
  EXPECT_NEAR(fifth.imag(), 0.4, kDigit);
}

// By its series, x - x^2 / 2 + x^3 / 3, where 1 + x has lost digits of x.
TEST(Functions, LogarithmsOfLittleMoreThanOneAreExact) {
  for (const double x : {0.0, 1e-300, 1e-17, 1.1e-16, 3e-16, 1e-10, 1e-6}) {
    EXPECT_NEAR(log_of_1_plus(x), x - x * x / 2 + x * x * x / 3, x * kDigit);
  }
  EXPECT_NEAR(log_of_1_plus(std::exp(1.0) - 1), 1, kDigit);
}

}  // namespace
}  // namespace mimo
