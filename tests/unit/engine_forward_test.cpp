// Looking at a world does not change where it goes: bit-exact, on the benchmark scene with all its contacts.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "base/random.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

// 240 steps of the fall with controls that change every step; `look` is called between the steps.
template <typename Look>
std::vector<double> fall(engine::Jacobian jacobian, Look&& look) {
  engine::PhysicsOptions options;
  options.jacobian = jacobian;
  engine::Physics physics(benchmark_model(), options);
  Random random(1);
  std::vector<double> states;
  int contacts = 0;
  for (int step = 0; step < 240; ++step) {
    for (int i = 0; i < physics.model().nu; ++i) physics.data().ctrl[i] = random.uniform(-1, 1);
    look(physics);
    const std::vector<double> state = trajectory(physics, 1);
    states.insert(states.end(), state.begin(), state.end());
    contacts = std::max(contacts, physics.data().ncon);
  }
  EXPECT_GT(contacts, 10) << "the comparison is worth little without contacts";
  return states;
}

class EngineForward : public ::testing::TestWithParam<engine::Jacobian> {};

TEST_P(EngineForward, ForwardKeepsTheTrajectory) {
  const std::vector<double> expected = fall(GetParam(), [](engine::Physics&) {});
  EXPECT_EQ(fall(GetParam(), [](engine::Physics& physics) { physics.forward(); }), expected);
  EXPECT_EQ(fall(GetParam(),
                 [](engine::Physics& physics) {
                   physics.forward();
                   physics.forward();
                 }),
            expected);
}

TEST_P(EngineForward, UpdatePosesKeepsTheTrajectory) {
  const std::vector<double> expected = fall(GetParam(), [](engine::Physics&) {});
  EXPECT_EQ(fall(GetParam(), [](engine::Physics& physics) { physics.update_poses(); }), expected);
}

INSTANTIATE_TEST_SUITE_P(Each, EngineForward, ::testing::Values(engine::Jacobian::kDense, engine::Jacobian::kSparse),
                         [](const auto& jacobian) {
                           return std::string(jacobian.param == engine::Jacobian::kDense ? "Dense" : "Sparse");
                         });

// Several steps at once compute sensors in the last one only; whoever reads them cannot tell.
TEST(EngineStep, SensorsAreThoseOfTheLastStep) {
  engine::Physics together(benchmark_model(), {});
  engine::Physics one_by_one(benchmark_model(), {});
  const auto sensors = [](const engine::Physics& physics) {
    return std::vector<double>(physics.data().sensordata, physics.data().sensordata + physics.model().nsensordata);
  };
  for (int i = 0; i < 40; ++i) {
    const std::vector<double> before = sensors(together);
    together.step(1, false);
    EXPECT_EQ(sensors(together), before) << "nobody asked for them";
    together.step(2);
    for (int step = 0; step < 3; ++step) one_by_one.step(1);
    ASSERT_EQ(trajectory(together, 0), trajectory(one_by_one, 0));
    ASSERT_EQ(sensors(together), sensors(one_by_one));
    ASSERT_NE(sensors(together), before);
  }
}

// The same seed, the same numbers: a world repeats itself after a reset, and so does a second world.
TEST(EngineReset, RepeatsTheTrajectory) {
  engine::Physics first(benchmark_model(), {});
  engine::Physics second(benchmark_model(), {});
  const std::vector<double> expected = trajectory(first, 150);
  EXPECT_EQ(trajectory(second, 150), expected);
  first.data().ctrl[3] = 1;
  first.data().xfrc_applied[20] = 5;
  first.data().qfrc_applied[20] = 5;
  first.step(10);
  first.reset();
  EXPECT_EQ(trajectory(first, 150), expected);
}

// After a free fall of one step from rest: v = -g dt, and z falls by g dt^2 (semi-implicit Euler).
TEST(EngineForward, PosesBelongToTheState) {
  engine::Physics physics(compiled(pile(1, "")), {});
  const double z = physics.data().qpos[2];
  physics.data().qpos[2] = z + 1;
  physics.step(1);
  const double dt = 0.005, g = 9.81;
  EXPECT_TRUE(close(-g * dt, physics.data().qvel[2]));
  EXPECT_TRUE(close(z + 1 - g * dt * dt, physics.data().qpos[2]));
  EXPECT_TRUE(close(z + 1, physics.data().xpos[3 + 2])) << "poses are those of the step's start";
  physics.update_poses();
  EXPECT_TRUE(close(z + 1 - g * dt * dt, physics.data().xpos[3 + 2]));
}

TEST(EngineOptions, ContactsAndGravityCanBeOff) {
  engine::PhysicsOptions options;
  options.contacts = false;
  engine::Physics sinking(compiled(pile(1, "")), options);
  sinking.step(200);
  EXPECT_EQ(sinking.data().ncon, 0);
  // z = z0 - g dt^2 n (n + 1) / 2
  EXPECT_TRUE(close(0.06 - 9.81 * 0.005 * 0.005 * 200 * 201 / 2, sinking.data().qpos[2]));
  options.gravity = false;
  engine::Physics floating(compiled(pile(1, "")), options);
  floating.step(200);
  EXPECT_EQ(floating.data().qpos[2], 0.06);
}

// A world changes its own copy of the options only.
TEST(EngineOptions, BelongToOneWorld) {
  const engine::ModelPtr model = benchmark_model();
  engine::PhysicsOptions options;
  options.jacobian = engine::Jacobian::kDense;
  options.gravity = false;
  const engine::Physics physics(model, options);
  EXPECT_EQ(physics.model().opt.jacobian, mjJAC_DENSE);
  EXPECT_EQ(physics.model().opt.disableflags, mjDSBL_GRAVITY);
  EXPECT_EQ(model->opt.jacobian, mjJAC_SPARSE);
  EXPECT_EQ(model->opt.disableflags, 0);
}

}  // namespace
}  // namespace mimo::test
