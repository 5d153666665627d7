// The spectrum of a stretch of sound, against the transform's definition; bands and the time between the ears.

#include "hearing/bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "base/numbers.h"
#include "hearing/ears.h"
#include "sound/air.h"

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
TEST(Transform, EqualsTheFourierTransform) {
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

constexpr double kRate = 16000;

Levels flat(double level) {
  Levels levels;
  levels.fill(level);
  return levels;
}

// A sine of a level in dB, as root of the mean square, at both ears.
std::array<std::array<float, kWindow>, kEars> tone(double frequency, double level, double late = 0) {
  std::array<std::array<float, kWindow>, kEars> samples;
  const double amplitude = sound::kReference * std::pow(10, level / 20) * std::sqrt(2);
  for (std::size_t i = 0; i < kWindow; ++i) {
    const double t = static_cast<double>(i) / kRate;
    samples[0][i] = static_cast<float>(amplitude * std::sin(2 * kPi * frequency * t));
    samples[1][i] = static_cast<float>(amplitude * std::sin(2 * kPi * frequency * (t - late)));
  }
  return samples;
}

// Glasberg and Moore (1990): 24 bands between 100 and 7200 Hz, evenly spaced on their scale.
TEST(Bands, LieAtTheFrequenciesOfGlasbergAndMoore) {
  const Levels centres = band_centres();
  EXPECT_NEAR(centres[0], 100, 1e-6);
  EXPECT_NEAR(centres[6], 512.8, 0.05);
  EXPECT_NEAR(centres[10], 1046.6, 0.05);
  EXPECT_NEAR(centres[23], 7200, 1e-6);
  EXPECT_NEAR(bandwidth(1046.6), 137.7, 0.05);
}

TEST(Bands, HearLevelsAboveTheThreshold) {
  const Bands bands(kRate, flat(20));
  const Levels centres = band_centres();
  for (std::size_t band = 0; band < kBands; ++band) {
    const Heard below = bands.hear(tone(centres[band], 17)), above = bands.hear(tone(centres[band], 23));
    for (std::size_t other = 0; other < kBands; ++other) {
      EXPECT_EQ(below.levels[0][other], 0) << centres[band];
      EXPECT_EQ(above.levels[1][other], above.levels[0][other]);
      if (other == band || band < 2) continue;  // the lowest are narrower than what 32 ms resolve
      EXPECT_LE(above.levels[0][other], 1) << centres[band] << " in " << centres[other];
    }
    EXPECT_NEAR(above.levels[0][band], 3, 1) << centres[band];
  }
}

TEST(Bands, ReportTheFirstEar) {
  const Bands bands(kRate, flat(0));
  for (const double late : {0.0, 1e-4, -1e-4, 2.5e-4, 4e-4, -5e-4}) {
    EXPECT_NEAR(bands.hear(tone(500, 60, late)).time_difference, late, 20e-6) << late;
  }
  EXPECT_EQ(bands.hear(tone(500, -10, 3e-4)).time_difference, 0);
}

TEST(Bands, DistinguishLeftFromRight) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<float> noise(0, 0.02F);
  const Bands bands(kRate, flat(15));
  const Head head{0.0735, Eigen::Vector3d::Zero(), ears_of_frame()};
  int right_side = 0, right_time = 0;
  for (int i = 0; i < 1000; ++i) {
    // Anywhere round the head, at least 5 degrees off the median plane.
    const double aside = (5 + 85 * unit(random)) * kDegree * (i % 2 == 0 ? 1 : -1), round = 2 * kPi * unit(random);
    const double distance = 0.3 + 2.7 * unit(random);
    const Eigen::Vector3d place = distance * Eigen::Vector3d(std::cos(aside) * std::cos(round), std::sin(aside),
                                                             std::cos(aside) * std::sin(round));
    std::vector<float> samples(1200);
    for (float& sample : samples) sample = noise(random);
    sound::Queue queue(samples.size());
    queue.add(samples, 0);
    Ears ears(80, kRate, kWindow, 1);
    for (std::int64_t now = 0; now < 1200; now += 80) {
      const Source source{&queue, place, now == 0};
      ears.advance(head, Span<const Source>(&source, 1), now);
    }
    std::array<std::array<float, kWindow>, kEars> window;
    for (std::size_t ear = 0; ear < kEars; ++ear) ears.latest(ear, window[ear]);
    const Heard heard = bands.hear(window);
    float louder = 0;
    for (std::size_t band = 0; band < kBands; ++band) louder += heard.levels[0][band] - heard.levels[1][band];
    right_side += (louder > 0) == (aside > 0);
    right_time += (heard.time_difference > 0) == (aside > 0);
  }
  EXPECT_EQ(right_side, 1000);
  EXPECT_EQ(right_time, 1000);
}

}  // namespace
}  // namespace mimo::hearing
