// What slides: 20 dB for ten times the speed, 10 dB for ten times the force, brighter when faster, silent at rest.
#include "sound/scrape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/numbers.h"
#include "sound/air.h"
#include "sound/impact.h"

namespace mimo::sound {
namespace {

constexpr double kRate = 16000;
const Solid kWood = {1.1e10, 0.25, 1e-4, 0, 1e-5};
const Solid kFoam = {1e5, 0.3, 0, -1, 2e-5};

Struck of(const Solid& solid, double curvature = 0) { return {solid, 20, curvature, 0.02, 0.12}; }

double level(const Sliding& sliding, const Solid& a = kWood, const Solid& b = kWood) {
  return 20 * std::log10(scrape_level(of(a), of(b), sliding).pressure / kReference);
}

std::vector<float> noise(const ScrapeLevel& level, double speed) {
  ScrapeNoise made;
  made.rest(7);
  std::vector<float> all;
  for (int i = 0; i < 400; ++i) {
    std::vector<float> block(80, 0.0F);
    made.sound(level, speed, kRate, block);
    all.insert(all.end(), block.begin(), block.end());
  }
  return all;
}

double square(const std::vector<float>& samples) {
  double sum = 0;
  for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
  return sum / static_cast<double>(samples.size());
}

// Share of the energy above about 2 kHz: of differences between samples.
double brightness(const std::vector<float>& samples) {
  double sum = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) sum += std::pow(static_cast<double>(samples[i] - samples[i - 1]), 2);
  return sum / static_cast<double>(samples.size()) / square(samples);
}

TEST(Scrape, FollowsSpeedAndForce) {
  EXPECT_NEAR(level({0.1, 1, false}), 40, 0.1);
  EXPECT_NEAR(level({1, 1, false}) - level({0.1, 1, false}), 20, 1e-9);
  EXPECT_NEAR(level({0.1, 10, false}) - level({0.1, 1, false}), 10, 1e-9);
}

TEST(Scrape, IsSilentAtRestAndForSoftMaterials) {
  EXPECT_EQ(scrape_level(of(kWood), of(kWood), {0.02, 1, false}).pressure, 0);
  EXPECT_EQ(scrape_level(of(kWood), of(kWood), {1, 0, false}).pressure, 0);
  EXPECT_EQ(scrape_level(of(kFoam), of(kFoam), {1, 1, false}).pressure, 0);
  ScrapeNoise still;
  std::vector<float> block(80);
  EXPECT_FALSE(still.sound({}, 0, kRate, block));
}

TEST(Scrape, HasTheMeasuredLevelAndIsBrighterWhenFaster) {
  for (const double speed : {0.1, 0.3, 0.8}) {
    const ScrapeLevel wanted = scrape_level(of(kWood), of(kWood), {speed, 1, false});
    EXPECT_NEAR(10 * std::log10(square(noise(wanted, speed)) / std::pow(wanted.pressure, 2)), 0, 0.5) << speed;
  }
  const ScrapeLevel same = {0.01, 0};
  EXPECT_GT(brightness(noise(same, 0.3)), 4 * brightness(noise(same, 0.1)));
  EXPECT_GT(brightness(noise(same, 0.8)), 2 * brightness(noise(same, 0.3)));
}

// v/(2 pi sqrt(R a)): a ball of 2 cm that presses with 0.5 N on wood touches it on a patch of a = 0.1085 mm (Hertz:
// cube root of 3 F R/(4 E*), E* = 5.867 GPa), so at 0.3 m/s 32.4 Hz.
TEST(Scrape, RollingIsDull) {
  const ScrapeLevel rolls = scrape_level(of(kWood, 50), of(kWood), {0.3, 0.5, true});
  EXPECT_NEAR(rolls.corner, 32.4, 0.2);
  EXPECT_LT(square(noise(rolls, 0.3)), 0.1 * square(noise({rolls.pressure, 0}, 0.3)));
}

}  // namespace
}  // namespace mimo::sound
