// How long nerves are, and what they take.
#include <gtest/gtest.h>

#include "body/nerves.h"
#include "growth/conduction.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

// A head 10 cm above its joint, a chest whose neck is 20 cm above its middle, and an arm of two parts. All lengths are
// in the text: the hand's way is 5 (to the elbow) + 30 (to the shoulder) + 50 (3-4-5 from there to the neck) + 10 cm.
const char* const kModel =
    "<mujoco><worldbody><body name='chest'><freejoint/><geom size='.1'/>"
    "<body name='head' pos='0 0 .3'><joint pos='0 0 -.1'/><geom size='.1'/></body>"
    "<body name='arm' pos='.4 0 -.1'><joint/><geom size='.05' pos='.15 0 0'/>"
    "<body name='hand' pos='.3 0 0'><joint axis='0 1 0'/><geom size='.03' pos='.05 0 0'/></body></body></body>"
    "<body name='ball'><geom size='.1'/></body></worldbody></mujoco>";

TEST(Nerves, GoThroughJointsToTheHead) {
  const engine::ModelPtr model = compiled(kModel);
  const auto id = [&](const char* name) { return engine::find_or_fail(*model, engine::Kind::kBody, name); };
  body::Body body;
  body.root = id("chest");
  body.head = id("head");
  body.bodies = body::subtree(*model, body.root);
  const std::vector<double> lengths = body::nerve_lengths(*model, body);
  const auto length = [&](const char* name) { return lengths[static_cast<std::size_t>(id(name))]; };
  EXPECT_NEAR(length("head"), 0.1, 1e-9);
  EXPECT_NEAR(length("chest"), 0.2 + 0.1, 1e-9);
  EXPECT_NEAR(length("arm"), 0.15 + 0.5 + 0.1, 1e-9);
  EXPECT_NEAR(length("hand"), 0.05 + 0.3 + 0.5 + 0.1, 1e-9);
  EXPECT_EQ(length("ball"), 0);
}

// From wrist to neck, .257 m in a newborn, and .34 m from hand to brain stem: N13 was measured at 10.1 ms, N20 at 38.9
// (Electroencephalogr Clin Neurophysiol 1988;71:100), and at 20 ms with six months.
TEST(Conduction, IsThatOfEvokedPotentials) {
  const growth::Conduction newborn = growth::conduction_at(0), half_a_year = growth::conduction_at(6);
  EXPECT_NEAR(newborn.along(0.257), 0.0105, 5e-5);
  EXPECT_NEAR(newborn.along(0.257) + newborn.sensory + 0.002, 0.0385, 1e-4);
  EXPECT_NEAR(newborn.along(0.34) + newborn.sensory, 0.040, 5e-4);
  EXPECT_NEAR(half_a_year.along(0.43) + half_a_year.sensory, 0.022, 1e-3);
}

// Rows of the table that the formula was published with here: face, hand and foot by their lengths, ms.
TEST(Conduction, FollowsItsTable) {
  const struct {
    double age, metres, sensory, motor;
  } rows[] = {{0, 0.34, 40, 36}, {0, 0.49, 46, 42},  {6, 0.43, 22, 24},
              {6, 0.63, 26, 29}, {18, 0.53, 19, 21}, {18, 0.79, 24, 27}};
  for (const auto& row : rows) {
    const growth::Conduction at = growth::conduction_at(row.age);
    EXPECT_NEAR(1000 * (at.along(row.metres) + at.sensory), row.sensory, 0.6) << row.age;
    EXPECT_NEAR(1000 * (at.along(row.metres) + at.motor), row.motor, 0.6) << row.age;
  }
}

// 0.6 of the measured wave: 256 ms at birth, 182 with six weeks, 104 later.
TEST(Conduction, OfTheEyesMaturesInTheFirstWeeks) {
  const double week = 7 / 30.4375;
  EXPECT_NEAR(growth::conduction_at(0).vision, 0.6 * 0.256, 1e-3);
  EXPECT_NEAR(growth::conduction_at(6 * week).vision, 0.6 * 0.182, 1e-3);
  EXPECT_NEAR(growth::conduction_at(24).vision, 0.6 * 0.104, 1e-3);
  for (double age = 0; age < 12; age += 0.25) {
    EXPECT_LT(growth::conduction_at(age + 0.25).vision, growth::conduction_at(age).vision + 1e-12);
    EXPECT_LT(growth::conduction_at(age + 0.25).sensory, growth::conduction_at(age).sensory);
  }
}

}  // namespace
}  // namespace mimo::test
