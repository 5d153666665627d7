// The spectrum of a stretch of sound, against the transform's definition.
#include "hearing/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "base/angle.h"

namespace mimo::hearing {
namespace {

std::complex<double> bin_of(const std::array<float, kWindow>& samples, std::size_t bin) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < kWindow; ++i) {
    const double part = static_cast<double>(bin * i % kWindow) / kWindow;
    sum += static_cast<double>(samples[i]) * std::polar(1.0, -2 * kPi * part);
  }
  return sum;
}

// Rounding of a float, 6e-8, in each of some ten steps.
TEST(Transform, IsFouriers) {
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0, 1);
  std::array<float, kWindow> samples;
  for (float& sample : samples) sample = noise(random);
  const Complexes spectrum = Transform()(samples);
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const std::complex<double> expected = bin_of(samples, bin);
    EXPECT_NEAR(spectrum.real[bin], expected.real(), 2e-6 * std::sqrt(kWindow)) << bin;
    EXPECT_NEAR(spectrum.imag[bin], expected.imag(), 2e-6 * std::sqrt(kWindow)) << bin;
  }
}

}  // namespace
}  // namespace mimo::hearing
