// What is felt of commands: an elbow with a motor of gear 3 that is told 0.5, and a lock that holds it at 0.25 rad.
#include <gtest/gtest.h>

#include "actuation/actuation.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using actuation::Mode;

engine::ModelPtr arm(bool with_lock = true) {
  const std::string lock = "<equality><joint joint1='elbow' polycoef='0.25 0 0 0 0'/></equality>";
  return compiled(
      "<mujoco><worldbody><body name='arm'><joint name='elbow' axis='0 1 0' limited='true' range='-60 60'/>"
      "<geom size='.1' mass='1'/></body></worldbody><actuator><motor name='push' joint='elbow' gear='3'/></actuator>" +
      (with_lock ? lock : "") + "</mujoco>");
}

class FeedbackTest : public ::testing::Test {
 protected:
  explicit FeedbackTest(bool with_lock = true) : physics_(arm(with_lock), {}) {
    body_ = body::find_part(physics_.model(), "arm");
    physics_.data().ctrl[0] = 0.5;
    physics_.forward();
  }

  actuation::Feedback felt(const actuation::Options& options, std::uint32_t wanted = MIMO_PROPRIOCEPTION_ACTUATION) {
    actuation_ = actuation::make_actuation(physics_.model(), body_, options);
    return actuation_->feedback(physics_.model(), body_, wanted);
  }
  // Of a signal that is a single number.
  double value(const observation::Signal& signal) const {
    EXPECT_EQ(signal.field.shape, std::vector<std::size_t>{1});
    float number = 0;
    signal.write(physics_.model(), physics_.data(), &number);
    return static_cast<double>(number);
  }

  engine::Physics physics_;
  body::Body body_;
  std::unique_ptr<actuation::Actuation> actuation_;
};

TEST_F(FeedbackTest, MotorsOfAnInfantReportTheirTorque) {
  body_.infant = true;
  const auto commands = felt({}).commands;
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[0].field.name, "proprioception/control");
  EXPECT_EQ(commands[0].field.labels, std::vector<std::string>{"push"});
  EXPECT_EQ(value(commands[0]), 0.5);
  EXPECT_EQ(commands[1].field.name, "proprioception/motor_torque");
  EXPECT_EQ(commands[1].field.unit, "Nm");
  EXPECT_EQ(value(commands[1]), 1.5);
}

TEST_F(FeedbackTest, ActuatorsOfOthersReportTheirForce) {
  const auto commands = felt({}).commands;
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[1].field.name, "proprioception/actuator_force");
  EXPECT_EQ(commands[1].field.time, observation::Time::kLastStart);
  EXPECT_EQ(value(commands[1]), 0.5) << "before the gear";
}

TEST_F(FeedbackTest, LocksReportTheirAngle) {
  const auto commands = felt({Mode::kPosition}).commands;
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_EQ(commands[0].field.name, "proprioception/target");
  EXPECT_EQ(commands[0].field.unit, "rad");
  EXPECT_EQ(value(commands[0]), 0.25);
}

TEST_F(FeedbackTest, IncludesCommandsOfOthers) {
  actuation::Options options;
  for (const Mode mode : {Mode::kTorque, Mode::kPosition}) {
    options.mode = mode;
    options.none = true;
    const auto commands = felt(options).commands;
    EXPECT_EQ(actuation_->size(), 0u);
    EXPECT_EQ(value(commands.at(0)), mode == Mode::kTorque ? 0.5 : 0.25);
  }
}

// The square of 0.5; a lock costs nothing.
TEST_F(FeedbackTest, EffortIsComputedOnRequest) {
  actuation::Options options;
  EXPECT_TRUE(felt(options).exertion.empty());
  const auto torque = felt(options, MIMO_PROPRIOCEPTION_EFFORT);
  EXPECT_TRUE(torque.commands.empty());
  ASSERT_EQ(torque.exertion.size(), 1u);
  EXPECT_EQ(torque.exertion[0].field.name, "proprioception/effort");
  EXPECT_EQ(value(torque.exertion[0]), 0.25);
  options.mode = Mode::kPosition;
  EXPECT_EQ(value(felt(options, MIMO_PROPRIOCEPTION_EFFORT).exertion.at(0)), 0);
}

class WithoutLock : public FeedbackTest {
 protected:
  WithoutLock() : FeedbackTest(false) {}
};

// Also by an agent that only looks on.
TEST_F(WithoutLock, PositionControlIsRefused) {
  actuation::Options options;
  options.mode = Mode::kPosition;
  for (const bool none : {false, true}) {
    options.none = none;
    expect_error(Status::kUnsupported, "joint elbow of push has no equality constraint in the model that could hold it",
                 [&] { felt(options); });
  }
}

}  // namespace
}  // namespace mimo::test
