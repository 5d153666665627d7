// The original's muscle model: its curves, and twenty steps with constant actions (muscle_mitten.json).
//
// The original updates activations once too often at the start of each step. The test does so, too, to come to the same
// numbers; what the library does by itself is tested in tests/unit/muscle_test.cpp.
#include "actuation/muscle.h"

#include <gtest/gtest.h>

#include "support/block.h"
#include "support/recording.h"

namespace mimo::test {
namespace {

using Curve = double (*)(double);

void expect_curve(const Json& places, const Json& values, Curve curve) {
  ASSERT_EQ(places.size(), values.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(curve(places[i]), values[i].get<double>(), 1e-9) << "at " << places[i];
  }
}

TEST(GoldenMuscle, Curves) {
  const Json curves = read_json("muscle_mitten.json").at("curves");
  ASSERT_EQ(curves.at("l").size(), 66u);
  ASSERT_EQ(curves.at("v_over_vmax").size(), 51u);
  expect_curve(curves.at("l"), curves.at("FL"), actuation::curves::force_length);
  expect_curve(curves.at("l"), curves.at("FP"), actuation::curves::passive_force);
  expect_curve(curves.at("v_over_vmax"), curves.at("FV"), actuation::curves::force_velocity);
}

std::unique_ptr<env::World> floating_muscles() {
  env::AgentOptions agent = blind();
  agent.actuation.mode = actuation::Mode::kMuscle;
  env::EnvOptions options = without_renderer();
  options.physics.gravity = options.physics.contacts = false;
  return benchmark_world(agent, options);
}

// The recording had actions in double; ours are float32, exact to 6e-8. MuJoCo 2.3.7 makes no further difference here.
TEST(GoldenMuscle, StepsWithConstantActions) {
  const Json golden = read_json("muscle_mitten.json");
  const auto world = floating_muscles();
  actuation::Actuation& actuation = *world->agents()[0].actuation;
  const std::vector<double> constants = golden.at("action_constant_neg_then_pos");
  const std::vector<float> actions(constants.begin(), constants.end());
  Observation observation(*world);
  ASSERT_EQ(golden.at("rec").size(), 20u);
  for (const Json& recorded : golden.at("rec")) {
    SCOPED_TRACE("step " + recorded.at("env_step").dump());
    actuation.apply(actions, world->physics());
    actuation.advance(world->physics());
    world->step({}, observation.data(), {});
    const std::vector<float> activation = observation["proprioception/activation"];
    ASSERT_EQ(activation.size(), recorded.at("activity").size());
    for (std::size_t i = 0; i < activation.size(); ++i) {
      EXPECT_NEAR(activation[i], recorded.at("activity")[i].get<double>(), 1e-7) << actuation.names()[i];
    }
    EXPECT_TRUE(close(recorded.at("cost").get<double>(), actuation.effort(world->model(), world->data()), {2e-7, 0}));
    for (int motor = 0; motor < world->model().nu; ++motor) {
      const double torque = world->data().ctrl[motor] * world->model().actuator_gear[6 * motor];
      const auto expected = recorded.at("joint_torque")[static_cast<std::size_t>(motor)].get<double>();
      EXPECT_NEAR(torque, expected, 2e-7) << golden.at("actuators")[static_cast<std::size_t>(motor)];
    }
    expect_positions(world->model(), recorded.at("qpos"), world->data().qpos, {2e-7, 2e-7});
  }
}

}  // namespace
}  // namespace mimo::test
