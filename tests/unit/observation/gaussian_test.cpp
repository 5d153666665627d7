// The Gaussian's weights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "observation/blur.h"

namespace mimo::observation {
namespace {

constexpr double kPi = 3.14159265358979323846;

// The largest difference to what a Gaussian leaves, up to `highest` cycles per pixel.
double error(double sigma, double highest) {
  const std::vector<float> kernel = gaussian_kernel(sigma);
  double error = 0;
  for (double f = 0; f <= highest; f += 0.001) {
    double left = kernel[0];
    for (std::size_t k = 1; k < kernel.size(); ++k) {
      left += 2 * static_cast<double>(kernel[k]) * std::cos(2 * kPi * static_cast<double>(k) * f);
    }
    error = std::max(error, std::abs(left - std::exp(-2 * std::pow(kPi * sigma * f, 2))));
  }
  return error;
}

TEST(Gaussian, AttenuatesByTheFormula) {
  for (double sigma = 0.02; sigma < 8.1; sigma *= 1.05) {
    EXPECT_LT(error(sigma, 0.4), sigma < 0.7 ? 0.006 : 0.003) << sigma;
    EXPECT_LT(error(sigma, 0.5), sigma < 1 ? 0.08 : 0.005) << sigma;
  }
}

// What is below 0 is little, 2 pixels away, and needed for narrow ones only: weights above 0 alone leave 0.025 too much
// of 0.4 cycles per pixel at 0.42 pixels.
TEST(Gaussian, SumsToOneAndIsHardlyEverNegative) {
  for (double sigma = 0.001; sigma < 1000; sigma *= 1.1) {
    const std::vector<float> kernel = gaussian_kernel(sigma);
    double sum = kernel[0];
    for (std::size_t k = 1; k < kernel.size(); ++k) {
      EXPECT_GE(kernel[k], sigma < 0.7 ? -0.015F : 0) << sigma;
      EXPECT_LE(std::abs(kernel[k]), std::abs(kernel[k - 1]) + (sigma < 0.7 ? 0.006F : 1.0F / 65536)) << sigma;
      sum += 2 * static_cast<double>(kernel[k]);
    }
    EXPECT_EQ(sum, 1) << sigma;
  }
}

TEST(Gaussian, IsASingleWeightWithoutBlur) { EXPECT_EQ(gaussian_kernel(0), std::vector<float>{1}); }

}  // namespace
}  // namespace mimo::observation
