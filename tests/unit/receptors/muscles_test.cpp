// Spindles, tendon organs and joint receptors against the numbers of their sources.
#include <gtest/gtest.h>

#include <cmath>

#include "receptors/joint_receptor.h"
#include "receptors/spindle.h"
#include "receptors/tendon_organ.h"

namespace mimo::receptors {
namespace {

const Fusimotion kNone{{0, 0}}, kBoth{{70, 70}}, kDynamic{{70, 0}}, kStatic{{0, 70}};

// Equilibria of the model of Mileusnic et al. 2006, solved from their table 1 without this library.
TEST(Spindle, HeldMusclesFireAsTheModelDoes) {
  const double idle[][3] = {{0.9, 0, 0}, {0.95, 0, 2.3}, {1.0, 12.2, 20.7}, {1.05, 28.5, 39.2}, {1.1, 44.8, 57.6}};
  for (const auto& [length, primary, secondary] : idle) {
    EXPECT_NEAR(spindle(length, 0, kNone).primary, primary, 0.1) << length;
    EXPECT_NEAR(spindle(length, 0, kNone).secondary, secondary, 0.1) << length;
  }
  const double driven[][3] = {{0.8, 22.4, 0}, {0.9, 52.8, 17.7}, {1.0, 85.5, 54.7}, {1.1, 118.2, 91.6}};
  for (const auto& [length, primary, secondary] : driven) {
    EXPECT_NEAR(spindle(length, 0, kBoth).primary, primary, 0.1) << length;
    EXPECT_NEAR(spindle(length, 0, kBoth).secondary, secondary, 0.1) << length;
  }
}

// Peaks of Ia and II at the end of ramps from 0.95 to 1.08 L0, of the full model in steps of 0.1 ms; the closed form is
// good to 3 %.
TEST(Spindle, RampsFireAsTheModelDoes) {
  const double known[][5] = {
      {0.11, 89.1, 192.0, 142.8, 72.9}, {0.66, 125.0, 277.1, 168.4, 88.8}, {1.55, 150.0, 336.0, 186.2, 99.9}};
  for (const auto& [speed, idle, dynamic_drive, static_drive, secondary] : known) {
    EXPECT_NEAR(spindle(1.08, speed, kNone).primary, idle, 0.03 * idle);
    EXPECT_NEAR(spindle(1.08, speed, kDynamic).primary, dynamic_drive, 0.03 * dynamic_drive);
    EXPECT_NEAR(spindle(1.08, speed, kStatic).primary, static_drive, 0.03 * static_drive);
    EXPECT_NEAR(spindle(1.08, speed, kNone).secondary, secondary, 0.03 * secondary);
  }
}

// The exponent of velocity is 0.3: twice as fast is 2^0.3 = 1.231 times as much above what is held.
TEST(Spindle, VelocityCountsByItsPower) {
  const double held = spindle(1.08, 0, kDynamic).primary;
  const double slow = spindle(1.08, 0.3, kDynamic).primary - held, fast = spindle(1.08, 0.6, kDynamic).primary - held;
  EXPECT_NEAR(fast / slow, 1.231, 0.002);
}

// The step answer of Lin and Crago's dynamics, times its final value.
TEST(TendonOrgan, AStepOvershoots) {
  constexpr double kTick = 0.005;
  const double slow = std::exp(-TendonOrgan::kSlow * kTick), fast = std::exp(-TendonOrgan::kFast * kTick);
  TendonOrgan organ;
  organ.rest(0);
  const double last = TendonOrgan::steady_rate(0.5);
  organ.advance(0.5, slow, fast);
  EXPECT_NEAR(organ.rate() / last, 1.7, 0.005 * 1.7);
  int at = 0;
  const double known[][2] = {{0.1, 1.595}, {0.5, 1.329}, {1, 1.186}, {2, 1.100}, {5, 1.049}, {10, 1.018}};
  for (const auto& [seconds, factor] : known) {
    for (; at < std::lround(seconds / kTick); ++at) organ.advance(0.5, slow, fast);
    EXPECT_NEAR(organ.rate() / last, factor, 0.005 * factor) << seconds;
  }
}

// 40 Hz ln(1 + 20 share): 27.7, 95.9 and 121.8 Hz of 5, 50 and 100 %; a muscle that does not pull is silent.
TEST(TendonOrgan, TellsForceByItsLogarithm) {
  EXPECT_NEAR(TendonOrgan::steady_rate(0.05), 27.7, 0.05);
  EXPECT_NEAR(TendonOrgan::steady_rate(0.5), 95.9, 0.05);
  EXPECT_NEAR(TendonOrgan::steady_rate(1), 121.8, 0.05);
  TendonOrgan organ;
  EXPECT_EQ(organ.rate(), 0);
}

TEST(JointReceptor, FiresNearAnEndOnly) {
  EXPECT_EQ(joint_receptor(0, 5), 0);
  EXPECT_DOUBLE_EQ(joint_receptor(0.5, 0), 50);
  EXPECT_DOUBLE_EQ(joint_receptor(2, 0), 100);
  EXPECT_DOUBLE_EQ(joint_receptor(0.5, 2), 70);  // and 100 Hz x 0.1 s x 2/s
  EXPECT_DOUBLE_EQ(joint_receptor(0.5, -2), 50);
}

}  // namespace
}  // namespace mimo::receptors
