// What becomes of actions on their way to the motors.
#include <gtest/gtest.h>

#include <cmath>

#include "actuation/motor_path.h"
#include "support/tiny.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using actuation::Mode;
using actuation::MotorLimits;

MotorLimits some(const std::string& name, const observation::Limits& limits) {
  return {name, [name](const std::string& action) { return action.compare(0, name.size(), name) == 0; }, limits};
}

observation::Limits delay(double seconds) { return {1, 0, 0, seconds}; }

std::unique_ptr<env::World> world_with(const std::vector<MotorLimits>& limits, Mode mode = Mode::kTorque) {
  env::AgentOptions agent = blind();
  agent.actuation.mode = mode;
  agent.motors = limits;
  return std::make_unique<env::World>(benchmark_model(), std::vector<env::AgentOptions>{agent}, env::EnvOptions{});
}

void step_all(env::World& world, float action) {
  const std::vector<float> actions(world.action_size(), action);
  world.step(Span<const float>(actions), nullptr, {});
}

int motor(const env::World& world, const char* name) {
  return engine::find_or_fail(world.model(), engine::Kind::kActuator, name);
}

double told(const env::World& world, const char* name) { return world.data().ctrl[motor(world, name)]; }

// A delay of 30 ms is three steps of 10 ms; before, motors are told nothing.
TEST(MotorPath, DelaysExactlyThatMotorAlone) {
  const auto world = world_with({some("act:left_elbow", delay(0.03))});
  for (int i = 1; i <= 6; ++i) {
    step_all(*world, 0.1F * static_cast<float>(i));
    EXPECT_NEAR(told(*world, "act:right_elbow"), 0.1F * static_cast<float>(i), 1e-7);
    EXPECT_NEAR(told(*world, "act:left_elbow"), i <= 3 ? 0 : 0.1F * static_cast<float>(i - 3), 1e-7);
  }
}

// What is on its way arrives, and then the motor stays as it was told last.
TEST(MotorPath, DeliversCommandsInStepsWithoutActions) {
  const auto world = world_with({some("act:", delay(0.02))});
  step_all(*world, 0.5F);
  world->step({}, nullptr, {});
  EXPECT_EQ(told(*world, "act:left_elbow"), 0);
  world->step({}, nullptr, {});
  EXPECT_EQ(told(*world, "act:left_elbow"), 0.5);
  world->step({}, nullptr, {});
  EXPECT_EQ(told(*world, "act:left_elbow"), 0.5);
}

TEST(MotorPath, ResetDropsCommandsInTransit) {
  const auto world = world_with({some("act:", delay(0.02))});
  step_all(*world, 0.5F);
  world->reset(nullptr, nullptr);
  for (int i = 0; i < 5; ++i) world->step({}, nullptr, {});
  EXPECT_EQ(told(*world, "act:left_elbow"), 0);
}

// Clipped, then halved: an action of 7 is 1 at most.
TEST(MotorPath, GainWorksOnClippedActions) {
  const auto world = world_with({some("act:left_elbow", {0.5, 0, 0, 0})});
  step_all(*world, 7);
  const double bound = world->model().actuator_forcerange[2 * motor(*world, "act:left_elbow") + 1];
  EXPECT_NEAR(told(*world, "act:left_elbow"), bound / 2, 1e-7);  // actions are floats
  const auto strong = world_with({some("act:left_elbow", {3, 0, 0, 0})});
  step_all(*strong, 0.9F);
  EXPECT_NEAR(told(*strong, "act:left_elbow"), bound, 1e-7);
}

// 2000 numbers: their mean is known to 0.05 / sqrt(2000) = 0.0011, their deviation to 0.0008; four times that is
// allowed.
TEST(MotorPath, NoiseHasItsDeviationAndFollowsFromTheSeed) {
  std::vector<double> first;
  for (int run = 0; run < 2; ++run) {
    const auto world = world_with({some("act:left_elbow", {1, 0.05, 0, 0})});
    const std::uint64_t seed = 4;
    world->reset(&seed, nullptr);
    std::vector<double> all;
    for (int i = 0; i < 2000; ++i) {
      step_all(*world, 0.25F);
      all.push_back(told(*world, "act:left_elbow") - 0.25);
      EXPECT_EQ(told(*world, "act:right_elbow"), 0.25);
    }
    if (run == 0) first = all;
    EXPECT_EQ(first, all);
  }
  double sum = 0, squares = 0;
  for (const double value : first) sum += value, squares += value * value;
  const double count = static_cast<double>(first.size());
  EXPECT_NEAR(sum / count, 0, 0.0044);
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.0032);
}

TEST(MotorPath, IsPartOfTheState) {
  for (const Mode mode : {Mode::kTorque, Mode::kPosition, Mode::kMuscle}) {
    const std::vector<MotorLimits> limits = {some("act:", {0.9, 0.1, 0, 0.05}), some("act:left", delay(0.02))};
    const auto one = world_with(limits, mode), other = world_with(limits, mode);
    const std::uint64_t seed = 8;
    one->reset(&seed, nullptr);
    for (int i = 0; i < 12; ++i) step(*one, i);
    step(*other, 100);
    EXPECT_EQ(other->load(Span<const std::uint8_t>(saved(*one))).fresh, 0u);
    for (int i = 12; i < 30; ++i) ASSERT_EQ(step(*one, i), step(*other, i)) << i;
    EXPECT_EQ(saved(*one), saved(*other));
  }
}

// The angle at which a lock holds its joint is late; a muscle's target too.
TEST(MotorPath, WorksForAnglesAndMuscles) {
  const auto angles = world_with({some("act:left_elbow", delay(0.02))}, Mode::kPosition);
  const int joint = engine::find_or_fail(angles->model(), engine::Kind::kJoint, "robot:left_elbow");
  const int lock = engine::find_lock(angles->model(), joint);
  const double before = engine::lock_angle(angles->model(), lock);
  step_all(*angles, -1);
  step_all(*angles, -1);
  EXPECT_EQ(engine::lock_angle(angles->model(), lock), before);
  step_all(*angles, -1);
  EXPECT_NEAR(engine::lock_angle(angles->model(), lock), -1, 1e-12);

  const auto muscles = world_with({some("act:left_elbow/positive", delay(0.02))}, Mode::kMuscle);
  const auto perfect = world_with({}, Mode::kMuscle);
  step_all(*muscles, 0.5F);
  step_all(*perfect, 0.5F);
  const double late = told(*muscles, "act:left_elbow"), prompt = told(*perfect, "act:left_elbow");
  EXPECT_LT(late, prompt - 1e-3);  // only the other one pulls
  // Others differ by what the arm does to them in the second physics step.
  EXPECT_NEAR(told(*muscles, "act:left_knee"), told(*perfect, "act:left_knee"), 1e-3);
}

TEST(MotorPath, DoesNotExistWithoutLimits) {
  EXPECT_EQ(world_with({})->agents()[0].path, nullptr);
  EXPECT_EQ(world_with({some("act:", {})})->agents()[0].path, nullptr);
}

TEST(MotorPath, RefusesAnUnknownPath) {
  expect_error(Status::kNotFound,
               "limits: no motor \"act:tail\"; the agent has: act:", [] { world_with({some("act:tail", delay(1))}); });
}

}  // namespace
}  // namespace mimo::test
