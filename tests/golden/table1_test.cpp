// Table I of the paper: ranges of motion and voluntary torques, after sign and split (README.md beside this file).
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <string>

#include "repository_paths.h"
#include "support/numbers.h"
#include "support/scenes.h"
#include "support/table.h"

namespace mimo::test {
namespace {

using engine::Kind;
using Limits = std::array<double, 2>;

const mjModel& model() {
  static const engine::ModelPtr compiled = benchmark_model();
  return *compiled;
}

// Joints in series add up: "robot:hip_bend1+robot:hip_bend2".
Limits range_of(const std::string& joints) {
  Limits sum = {0, 0};
  for (const std::string& name : split(joints, '+')) {
    const int id = engine::find_or_fail(model(), Kind::kJoint, name);
    for (std::size_t end = 0; end < 2; ++end)
      sum[end] += model().jnt_range[2 * id + static_cast<int>(end)] * 180 / mjPI;
  }
  return sum;
}

Limits torque_of(const std::string& actuator) {
  const int id = engine::find_or_fail(model(), Kind::kActuator, actuator);
  const double gear = model().actuator_gear[6 * id];
  return {gear * model().actuator_forcerange[2 * id], gear * model().actuator_forcerange[2 * id + 1]};
}

Limits turned(const Limits& limits, double sign) { return sign > 0 ? limits : Limits{-limits[1], -limits[0]}; }

bool excepted(const Table::Row& row, const std::string& what) {
  return (" " + row.text("excepted") + " ").find(" " + what + " ") != std::string::npos;
}

// Excepted numbers must really differ: else they are no exceptions any more.
void compare(const Table::Row& row, const std::string& what, double expected, double actual, double tolerance) {
  const auto result = close(expected, actual, {tolerance, 1e-9});
  if (excepted(row, what)) {
    EXPECT_FALSE(result) << what << " is listed as an exception, but agrees with the paper";
  } else {
    EXPECT_TRUE(result) << what;
  }
}

TEST(GoldenTable1, RangesAndTorques) {
  const Table table(std::string(MIMO_TEST_DATA) + "/table1.csv");
  EXPECT_EQ(table.size(), 21u);
  for (const Table::Row& row : table.rows()) {
    for (const std::string& joints : split(row.text("joints"), '|')) {
      SCOPED_TRACE(row.label() + ", " + joints);
      const Limits range = turned(range_of(joints), row.number("range_sign"));
      compare(row, "range_low", row.number("range_low_deg"), range[0], kRelative);
      compare(row, "range_high", row.number("range_high_deg"), range[1], kRelative);
    }
    const double tolerance = std::max(kRelative, row.number("torque_tolerance"));
    for (const std::string& actuator : split(row.text("actuators"), '|')) {
      SCOPED_TRACE(row.label() + ", " + actuator);
      const Limits torque = turned(torque_of(actuator), row.number("torque_sign"));
      compare(row, "torque_low", row.number("torque_low_nm"), torque[0], tolerance);
      compare(row, "torque_high", row.number("torque_high_nm"), torque[1], tolerance);
    }
  }
}

}  // namespace
}  // namespace mimo::test
