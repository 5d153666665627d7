// Muscles in a world: activation, force, stiffness, effort, and what they change of the model.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "access/access.h"
#include "actuation/muscle.h"
#include "support/block.h"
#include "support/numbers.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using actuation::Mode;
using engine::Kind;
using env::World;

std::unique_ptr<World> muscular(Mode mode, int frame_skip = 2) {
  env::AgentOptions agent = blind();
  agent.actuation.mode = mode;
  agent.proprioception.wanted |= MIMO_PROPRIOCEPTION_EFFORT;
  env::EnvOptions options = without_renderer();
  options.frame_skip = frame_skip;
  options.physics.gravity = options.physics.contacts = false;
  return std::make_unique<World>(benchmark_model(), std::vector<env::AgentOptions>{agent}, options);
}

int joint_id(const World& world, const std::string& name) {
  return engine::find_or_fail(world.model(), Kind::kJoint, name);
}

int motor_id(const World& world, const std::string& name) {
  return engine::find_or_fail(world.model(), Kind::kActuator, name);
}

double& angle(World& world, const std::string& joint) {
  return world.physics().data().qpos[world.model().jnt_qposadr[joint_id(world, joint)]];
}

std::size_t action_index(const World& world, const std::string& name) {
  const auto& names = world.agents()[0].actuation->names();
  const auto found = std::find(names.begin(), names.end(), name);
  EXPECT_NE(found, names.end()) << name;
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<float> all(const World& world, float value) { return std::vector<float>(world.action_size(), value); }

void run(World& world, const std::vector<float>& actions, int steps) {
  for (int i = 0; i < steps; ++i) world.step(actions, nullptr, {});
}

TEST(Muscle, TwoActionsAMotorFromZeroToOne) {
  const auto world = muscular(Mode::kMuscle);
  const auto& actuation = *world->agents()[0].actuation;
  ASSERT_EQ(actuation.size(), 88u);
  EXPECT_EQ(actuation.names()[0], "act:hip_bend/negative");
  EXPECT_EQ(actuation.names()[44], "act:hip_bend/positive");
  for (std::size_t i = 0; i < actuation.size(); ++i) {
    EXPECT_EQ(actuation.low()[i], 0);
    EXPECT_EQ(actuation.high()[i], 1);
  }
}

// Time constant 10 ms, step 5 ms: each physics step goes half of the way that is left, however many make an
// environment step.
TEST(Muscle, ActivationGoesHalfTheWayEachPhysicsStep) {
  for (const int frame_skip : {1, 2, 3}) {
    const auto world = muscular(Mode::kMuscle, frame_skip);
    Observation observation(*world);
    for (int step = 1; step <= 4; ++step) {
      world->step(all(*world, 0.8f), observation.data(), {});
      const double expected = 0.8 * (1 - std::pow(0.5, step * frame_skip));
      for (const float activation : observation["proprioception/activation"]) EXPECT_NEAR(activation, expected, 1e-7);
    }
    world->step_physics(2);
    world->observe(observation.data());
    const double expected = 0.8 * (1 - std::pow(0.5, 4 * frame_skip + 2));
    EXPECT_NEAR(observation.at("proprioception/activation", "act:hip_bend/negative"), expected, 1e-7);
    world->reset(nullptr, observation.data());
    EXPECT_EQ(observation.at("proprioception/activation", "act:hip_bend/negative"), 0);
  }
}

// The elbow's numbers: range -146 to 5 degrees, rest -20, fastest 1.566, peak forces 35.43 and 27.04 (the original's
// tables). Lengths go from 0.75 to 1.05 over the range.
struct Elbow {
  double angle, velocity;
  double slope() const { return 0.3 / (151 * M_PI / 180); }
  double length(bool positive) const {
    const double from_low = angle + 146 * M_PI / 180, from_high = 5 * M_PI / 180 - angle;
    return 0.75 + slope() * (positive ? from_high : from_low);
  }
  double velocity_of(bool positive) const { return (positive ? -1 : 1) * slope() * velocity / 1.566; }
  double peak(bool positive) const { return positive ? 27.04 : 35.43; }
};

TEST(Muscle, TorqueOfTheElbow) {
  const auto world = muscular(Mode::kMuscle, 1);
  Observation observation(*world);
  const int dof = world->model().jnt_dofadr[joint_id(*world, "robot:right_elbow")];
  std::vector<float> actions = all(*world, 0);
  actions[action_index(*world, "act:right_elbow/negative")] = 0.5f;
  actions[action_index(*world, "act:right_elbow/positive")] = 0.25f;
  for (const Elbow& elbow : {Elbow{-1, 0}, Elbow{-2.4, 3}, Elbow{0.05, -2}, Elbow{-0.3, 9}}) {
    world->reset(nullptr, nullptr);
    angle(*world, "robot:right_elbow") = elbow.angle;
    world->physics().data().qvel[dof] = elbow.velocity;
    world->step(actions, observation.data(), {});
    double torque = 0;
    for (const bool positive : {false, true}) {
      const double activation = (positive ? 0.25 : 0.5) / 2;
      namespace curves = actuation::curves;
      const double force = elbow.peak(positive) * (activation * curves::force_length(elbow.length(positive)) *
                                                       curves::force_velocity(elbow.velocity_of(positive)) +
                                                   curves::passive_force(elbow.length(positive)));
      torque += (positive ? 1 : -1) * elbow.slope() * force;
    }
    EXPECT_NEAR(world->data().qfrc_actuator[dof], torque, 1e-8);
  }
}

// At length 1, at rest and without passive force, a muscle pulls with its activation's share of its peak force, in
// both models.
TEST(Muscle, PullsItsPeakForceAtItsBestLength) {
  for (const Mode mode : {Mode::kMuscle, Mode::kMujocoMuscle}) {
    const auto world = muscular(mode);
    run(*world, all(*world, 1), 100);
    const double best = -146 * M_PI / 180 + 0.25 / (0.3 / (151 * M_PI / 180));
    angle(*world, "robot:right_elbow") = best;
    world->physics().data().qvel[world->model().jnt_dofadr[joint_id(*world, "robot:right_elbow")]] = 0;
    Observation observation(*world);
    world->observe(observation.data());
    EXPECT_NEAR(observation.at("proprioception/activation", "act:right_elbow/negative"), 1, 1e-6);
    EXPECT_NEAR(observation.at("proprioception/muscle_force", "act:right_elbow/negative"), 35.43, 1e-4);
  }
}

// MuJoCo's documentation: the rate is (control - activation) / tau, with tau = 0.01 (0.5 + 1.5 activation) when it
// rises and 0.04 / (0.5 + 1.5 activation) when it falls.
TEST(MujocoMuscle, RisesFastAndFallsSlowly) {
  const auto world = muscular(Mode::kMujocoMuscle, 1);
  Observation observation(*world);
  double activation = 0;
  for (int step = 0; step < 60; ++step) {
    const double control = step < 20 ? 0.75 : 0.125;
    const double bend = 0.5 + 1.5 * activation;
    const double tau = control > activation ? 0.01 * bend : 0.04 / bend;
    activation = std::min(1.0, activation + 0.005 * (control - activation) / tau);
    world->step(all(*world, static_cast<float>(control)), observation.data(), {});
    EXPECT_NEAR(observation.at("proprioception/activation", "act:left_knee/positive"), activation, 1e-6) << step;
  }
}

// How far a torque of 0.5 Nm turns the elbow.
double give_way(Mode mode, float both) {
  const auto world = muscular(mode);
  const int elbow = joint_id(*world, "robot:right_elbow");
  std::vector<float> actions = all(*world, 0.1f);
  for (const char* side : {"/negative", "/positive"}) {
    actions[action_index(*world, std::string("act:right_elbow") + side)] = both;
  }
  run(*world, actions, 300);
  const double before = angle(*world, "robot:right_elbow");
  world->physics().data().qfrc_applied[world->model().jnt_dofadr[elbow]] = 0.5;
  run(*world, actions, 300);
  return angle(*world, "robot:right_elbow") - before;
}

TEST(Muscle, CoContractionStiffens) {
  for (const Mode mode : {Mode::kMuscle, Mode::kMujocoMuscle}) {
    EXPECT_GT(give_way(mode, 0.3f), 2 * give_way(mode, 1)) << "both pull, and the joint gives way less";
    EXPECT_GT(give_way(mode, 1), 0);
  }
}

TEST(Muscle, EffortIsTheOriginals) {
  const auto world = muscular(Mode::kMuscle);
  Observation observation(*world);
  for (int i = 0; i < 40; ++i) world->step(all(*world, 1), observation.data(), {});
  EXPECT_NEAR(observation["proprioception/effort"][0], 1.0 / 88, 1e-8) << "of 88 muscles";
  for (int i = 0; i < 40; ++i) world->step(all(*world, 0.5f), observation.data(), {});
  EXPECT_NEAR(observation["proprioception/effort"][0], 0.25 / 88, 1e-8);
}

TEST(Effort, OfMotorsAndLocks) {
  const auto motors = muscular(Mode::kTorque), locks = muscular(Mode::kPosition);
  Observation observation(*motors);
  std::vector<float> actions = all(*motors, 0);
  actions[action_index(*motors, "act:right_knee")] = 0.5f;  // gear 10
  motors->step(actions, observation.data(), {});
  double gears = 0;
  for (int i = 0; i < motors->model().nu; ++i) gears += motors->model().actuator_gear[6 * i];
  EXPECT_NEAR(observation["proprioception/effort"][0], 0.25 * 10 / (44 * gears), 1e-9);
  Observation held(*locks);
  locks->step(all(*locks, 0.1f), held.data(), {});
  EXPECT_EQ(held["proprioception/effort"][0], 0);
}

// In this world only: the shared model keeps its springs, dampers and limits.
TEST(Muscle, StandsForSpringsDampersAndLimits) {
  const auto world = muscular(Mode::kMuscle);
  const mjModel& shared = *benchmark_model();
  for (const body::Joint& joint : world->agents()[0].body.joints) {
    EXPECT_EQ(world->model().jnt_stiffness[joint.id], 0);
    EXPECT_GT(shared.jnt_stiffness[joint.id], 0);
    EXPECT_DOUBLE_EQ(20 * world->model().dof_damping[joint.dof], shared.dof_damping[joint.dof]);
  }
  for (int i = 0; i < shared.nu; ++i) {
    EXPECT_EQ(world->model().actuator_forcelimited[i] + world->model().actuator_ctrllimited[i], 0);
    EXPECT_EQ(shared.actuator_forcelimited[i] + shared.actuator_ctrllimited[i], 2);
  }
}

// A gear of one's own makes muscles weaker or stronger.
TEST(Muscle, GearScalesTheTorque) {
  const auto strong = muscular(Mode::kMuscle, 1), weak = muscular(Mode::kMuscle, 1);
  const int elbow = motor_id(*weak, "act:right_elbow");
  weak->physics().gear(elbow) *= 0.5;
  const int dof = weak->model().jnt_dofadr[joint_id(*weak, "robot:right_elbow")];
  std::vector<float> actions = all(*weak, 0);
  actions[action_index(*weak, "act:right_elbow/negative")] = 1;
  strong->step(actions, nullptr, {});
  weak->step(actions, nullptr, {});
  EXPECT_LT(strong->data().qfrc_actuator[dof], -0.5);
  EXPECT_NEAR(weak->data().qfrc_actuator[dof], 0.5 * strong->data().qfrc_actuator[dof], 1e-12);
}

TEST(Muscle, StateHoldsActivationsAndTargets) {
  for (const Mode mode : {Mode::kMuscle, Mode::kMujocoMuscle}) {
    const auto world = muscular(mode), twin = muscular(mode);
    run(*world, all(*world, 0.7f), 3);
    std::vector<std::uint8_t> state(world->state_bytes());
    world->save(Span<std::uint8_t>(state));
    twin->load(Span<const std::uint8_t>(state));
    for (int i = 0; i < 5; ++i) {
      world->step({}, nullptr, {});
      twin->step({}, nullptr, {});
    }
    EXPECT_EQ(copy(world->data().qpos, world->model().nq), copy(twin->data().qpos, twin->model().nq));
  }
  const auto muscles = muscular(Mode::kMuscle), motors = muscular(Mode::kTorque);
  std::vector<std::uint8_t> state(motors->state_bytes());
  motors->save(Span<std::uint8_t>(state));
  expect_error(Status::kMismatch, "another task, actuation", [&] { muscles->load(Span<const std::uint8_t>(state)); });
}

TEST(Muscle, NeedsTheNumbersOfAMotor) {
  scene::Scene scene(
      from_text("<mujoco><include file='mimo/mitten.xml'/><actuator><motor name='act:tail' joint='robot:left_elbow' "
                "gear='1'/></actuator></mujoco>"));
  env::AgentOptions agent = blind();
  agent.actuation.mode = Mode::kMuscle;
  expect_error(Status::kUnsupported, "user number 0 of act:tail is 0",
               [&] { World(compile(scene), {agent}, without_renderer()); });
}

}  // namespace
}  // namespace mimo::test
