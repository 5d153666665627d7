// Blows: how long things touch, how loud that is, what rings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sound/air.h"
#include "sound/impact.h"

namespace mimo::sound {
namespace {

constexpr int kHardPlastic = 4, kHardWood = 6;  // rows of kTimbreTable

// Young's modulus and Poisson's ratio of wood and hard plastic, as engineering tables have them.
const Solid kWood = {1.1e10, 0.25, 1e-4, kHardWood};
const Solid kPlastic = {1.4e9, 0.35, 1e-4, kHardPlastic};
const Solid kHand = {1e6, 0.49, 0, -1};

// A block of 50 g with sides of 4 cm or so against something that stands.
Struck block(const Solid& solid, double mass = 0.05, double size = 0.02) {
  return {solid, 1 / mass, 1 / size, size, 6 * size};
}
Struck table(const Solid& solid) { return {solid, 0, 0, 1, 3}; }

double peak_level(const Click& click, double rate = 1e6) {
  const ClickWave wave(click);
  double peak = 0;
  for (int i = 0; i < 0.02 * rate; ++i) peak = std::max(peak, std::abs(wave.at(i / rate)));
  return 20 * std::log10(peak / kReference);
}

double event_level(const Click& click, double rate, double onset = 0) {
  const ClickWave wave(click);
  double sum = 0;
  for (int i = 0; i < 0.03 * rate; ++i) sum += std::pow(wave.at((i - onset) / rate), 2) / rate;
  return 10 * std::log10(sum / (kReference * kReference));
}

Click of(const Solid& solid, const Solid& under, double mass, double size, double speed) {
  const Struck body = block(solid, mass, size);
  return click(strike(body, table(under), speed), body.inverse_mass, body.radius, 1);
}

// Hertz' formula for the touch, a dipole's exact solution for the sound: worked out apart from this library.
TEST(Click, HasTheLoudnessOfTheFormula) {
  struct Row {
    double speed, duration, peak, level;
  };
  for (const Row& row :
       {Row{0.1, 0.37e-3, 70, 33}, Row{0.3, 0.30e-3, 83, 45}, Row{1, 0.23e-3, 96, 58}, Row{3, 0.19e-3, 108, 69}}) {
    const Click made = of(kWood, kWood, 0.05, 0.02, row.speed);
    EXPECT_NEAR(made.duration, row.duration, 0.006e-3) << row.speed;
    EXPECT_NEAR(peak_level(made), row.peak, 1) << row.speed;
    EXPECT_NEAR(event_level(made, kNominalRate, 0.3), row.level, 1) << row.speed;
  }
  for (const Row& row : {Row{0.1, 0.66e-3, 61, 26}, Row{1, 0.42e-3, 88, 52}}) {
    const Click made = of(kPlastic, kWood, 0.05, 0.02, row.speed);
    EXPECT_NEAR(made.duration, row.duration, 0.006e-3) << row.speed;
    EXPECT_NEAR(peak_level(made), row.peak, 1) << row.speed;
    EXPECT_NEAR(event_level(made, kNominalRate, 0.3), row.level, 1) << row.speed;
  }
}

// Skin gives way: it touches for some ten milliseconds, and hardly anything of that is above 100 Hz.
TEST(Click, IsNearlySilentForAHand) {
  const Click made = of(kHand, kWood, 0.06, 0.02, 0.3);
  EXPECT_GT(made.duration, 8e-3);
  EXPECT_LT(made.duration, 13e-3);
  EXPECT_LT(peak_level(made, 1e5), 32);
}

TEST(Click, HasTheSameLoudnessBetweenSamples) {
  const Click made = of(kWood, kWood, 0.05, 0.02, 1);
  const double exact = event_level(made, 1e6);
  for (const double onset : {0.0, 0.1, 0.25, 0.5, 0.77, 0.9}) {
    EXPECT_NEAR(event_level(made, kNominalRate, onset), exact, 0.3) << onset;
  }
}

TEST(Ringing, HasTheEnergyOfItsFormula) {
  const Struck body = block(kWood);
  // So short a touch that it holds all frequencies.
  const Ringing made = ringing({1e-9, 0.05, 1}, body);
  double sum = 0;
  const double rate = 48000;
  for (int i = 0; i < rate; ++i) {
    double pressure = 0;
    for (std::size_t k = 0; k < made.count; ++k) {
      const Mode& mode = made.modes[k];
      const double t = i / rate;
      pressure += mode.gain * std::exp(-6.91 * t / mode.decay) * std::sin(2 * 3.14159265358979 * mode.frequency * t);
    }
    sum += pressure * pressure / rate;
  }
  // 1e-4 of half m v^2 through a sphere of 1 m, over rho c.
  EXPECT_NEAR(sum / (1e-4 * 0.5 * 0.05 * 1.2 * 343 / (4 * 3.14159265)), 1, 0.02);
}

TEST(Ringing, IsSilentForSoftMaterials) {
  const Struck hand = block(kHand);
  EXPECT_EQ(ringing(strike(hand, table(kWood), 1), hand).count, 0U);
}

}  // namespace
}  // namespace mimo::sound
