// Spindles, tendon organs and joint receptors against the numbers of their sources.
#include "receptors/muscles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mimo::receptors {
namespace {

const FusimotorDrive kNone{0, 0}, kBoth{70, 70}, kDynamic{70, 0}, kStatic{0, 70};

SpindleRates held(double length, const FusimotorDrive& drive) {
  Spindle spindle;
  spindle.rest(length, drive);
  return spindle.rates();
}

// Equilibria of the model of Mileusnic et al. 2006, solved from their table 1 without this library.
TEST(Spindle, HeldMusclesFireAsTheModelDoes) {
  const double idle[][3] = {{0.9, 0, 0}, {0.95, 0, 2.3}, {1.0, 12.2, 20.7}, {1.05, 28.5, 39.2}, {1.1, 44.8, 57.6}};
  for (const auto& [length, primary, secondary] : idle) {
    EXPECT_NEAR(held(length, kNone).primary, primary, 0.1) << length;
    EXPECT_NEAR(held(length, kNone).secondary, secondary, 0.1) << length;
  }
  const double driven[][3] = {{0.8, 22.4, 0}, {0.9, 52.8, 17.7}, {1.0, 85.5, 54.7}, {1.1, 118.2, 91.6}};
  for (const auto& [length, primary, secondary] : driven) {
    EXPECT_NEAR(held(length, kBoth).primary, primary, 0.1) << length;
    EXPECT_NEAR(held(length, kBoth).secondary, secondary, 0.1) << length;
  }
}

// A ramp from 0.95 to 1.08 L0: rates at its end, and half a second after it.
struct Ramp {
  SpindleRates peak, later;
};
Ramp ramp(double speed, const FusimotorDrive& drive, double tick) {
  Spindle spindle;
  spindle.rest(0.95, drive);
  const SpindleTick each(tick);
  const double seconds = 0.13 / speed;
  Ramp told{{0, 0}, {0, 0}};
  for (int i = 1; i <= std::lround((seconds + 0.5) / tick); ++i) {
    spindle.advance(std::min(1.08, 0.95 + speed * tick * i), drive, each);
    told.later = spindle.rates();
    told.peak.primary = std::max(told.peak.primary, told.later.primary);
    told.peak.secondary = std::max(told.peak.secondary, told.later.secondary);
  }
  return told;
}

// Peaks of Ia and II and what is left of Ia after half a second of creep, of the model solved in steps of 0.1 ms.
// In the same steps this has to be it; in those of a world, fifty times as long, it is good to 3 %.
TEST(Spindle, RampsFireAsTheModelDoes) {
  struct Known {
    double speed, idle, dynamic_drive, static_drive, secondary;
  };
  const Known known[] = {
      {0.11, 89.1, 192.0, 142.8, 72.9}, {0.66, 125.0, 277.1, 168.4, 88.8}, {1.55, 150.0, 336.0, 186.2, 99.9}};
  for (const double tick : {1e-4, 5e-3}) {
    const double near = tick < 1e-3 ? 0.003 : 0.03;
    for (const Known& row : known) {
      const Ramp idle = ramp(row.speed, kNone, tick), dynamic_one = ramp(row.speed, kDynamic, tick);
      const Ramp static_one = ramp(row.speed, kStatic, tick);
      EXPECT_NEAR(idle.peak.primary, row.idle, near * row.idle) << row.speed << " " << tick;
      EXPECT_NEAR(dynamic_one.peak.primary, row.dynamic_drive, near * row.dynamic_drive) << row.speed << " " << tick;
      EXPECT_NEAR(static_one.peak.primary, row.static_drive, near * row.static_drive) << row.speed << " " << tick;
      EXPECT_NEAR(idle.peak.secondary, row.secondary, near * row.secondary) << row.speed << " " << tick;
      EXPECT_NEAR(idle.later.primary, 47.3, 0.01 * 47.3) << row.speed << " " << tick;
      EXPECT_NEAR(dynamic_one.later.primary, row.speed > 1 ? 101.9 : 101.6, 0.01 * 101.6) << row.speed << " " << tick;
      EXPECT_NEAR(static_one.later.primary, 112.2, 0.01 * 112.2) << row.speed << " " << tick;
      EXPECT_NEAR(idle.later.secondary, 54.3, 0.01 * 54.3) << row.speed << " " << tick;
    }
  }
}

// A drive contracts bag1 with 0.149 s. 70 Hz of the dynamic one add 20000 x 0.0289 / 10.6149 x 70^2 / (70^2 + 60^2) =
// 31.39 Hz of Ia in the end; after 0.149 s at most 1 - 1/e of them, as creep only holds them back, and little of what
// is missing after 3 s.
TEST(Spindle, ADriveContractsSlowly) {
  Spindle spindle;
  spindle.rest(1.0, kNone);
  const double before = spindle.rates().primary, gained = held(1.0, kDynamic).primary - before;
  EXPECT_NEAR(gained, 31.39, 0.01);
  const SpindleTick tick(1e-3);
  for (int i = 0; i < 149; ++i) spindle.advance(1.0, kDynamic, tick);
  EXPECT_LT(spindle.rates().primary - before, 0.632 * gained);
  EXPECT_GT(spindle.rates().primary - before, 0.2 * gained);
  for (int i = 0; i < 2851; ++i) spindle.advance(1.0, kDynamic, tick);
  EXPECT_NEAR(spindle.rates().primary - before, gained, 0.15 * gained);
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
TEST(TendonOrgan, EncodesTheLogarithmOfForce) {
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
