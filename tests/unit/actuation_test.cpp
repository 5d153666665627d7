// From actions to joints: which parts act, torque and position control, mapped actions; locks, gears and gravity of one
// world only.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "access/access.h"
#include "compat/mujoco.h"
#include "scene/anatomy.h"
#include "support/access.h"
#include "support/block.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using env::World;

engine::ModelPtr free_room() {
  static const engine::ModelPtr model = room_with_infant("free");
  return model;
}

std::unique_ptr<World> floating(const actuation::Options& actuation = {}) {
  env::AgentOptions agent = blind();
  agent.actuation = actuation;
  env::EnvOptions options = without_renderer();
  options.physics.gravity = options.physics.contacts = false;
  return std::make_unique<World>(free_room(), std::vector<env::AgentOptions>{agent}, options);
}

int joint_id(const World& world, const std::string& name) {
  return engine::find_or_fail(world.model(), Kind::kJoint, name);
}

double angle(const World& world, const std::string& joint) {
  return world.data().qpos[world.model().jnt_qposadr[joint_id(world, joint)]];
}

std::size_t action_index(const World& world, const std::string& name) {
  for (std::size_t i = 0; i < world.action_size(); ++i) {
    if (world.agents()[0].actuation->names()[i] == name) return i;
  }
  ADD_FAILURE() << "no action " << name;
  return 0;
}

void run(World& world, const std::vector<float>& actions, int steps) {
  for (int i = 0; i < steps; ++i) world.step(actions, nullptr, {});
}

constexpr actuation::Options kPosition = {actuation::Mode::kPosition, false};

TEST(Groups, EveryMotorBelongsToOne) {
  std::map<unsigned, int> motors;
  const mjModel& model = *free_room();
  for (int id = 0; id < model.nu; ++id) {
    const unsigned group = scene::group_of(engine::name(model, Kind::kActuator, id));
    EXPECT_NE(group, 0u) << engine::name(model, Kind::kActuator, id);
    ++motors[group];
  }
  const std::map<unsigned, int> expected = {{scene::kTrunk, 3},     {scene::kHead, 3},     {scene::kEyes, 6},
                                            {scene::kRightArm, 4},  {scene::kLeftArm, 4},  {scene::kRightHand, 4},
                                            {scene::kLeftHand, 4},  {scene::kRightLeg, 4}, {scene::kLeftLeg, 4},
                                            {scene::kRightFoot, 4}, {scene::kLeftFoot, 4}};
  EXPECT_EQ(motors, expected);
  expect_error(Status::kModel, "\"tail\" is not a part", [] { scene::groups_from("head tail"); });
}

// 22 motors for five fingers in place of one for a mitten, a further one for each big toe.
TEST(Groups, HandsWithFiveFingersHaveMore) {
  std::map<unsigned, int> motors;
  const engine::ModelPtr model = room_with_infant("free", "fingers");
  for (int id = 0; id < model->nu; ++id) ++motors[scene::group_of(engine::name(*model, Kind::kActuator, id))];
  EXPECT_EQ(motors[scene::kRightHand], 25);
  EXPECT_EQ(motors[scene::kLeftHand], 25);
  EXPECT_EQ(motors[scene::kRightFoot], 5);
  EXPECT_EQ(motors[scene::kLeftFoot], 5);
  EXPECT_EQ(motors[scene::kRightArm], 4);
  EXPECT_EQ(motors.count(0), 0u);
}

TEST(Groups, AreSwitchedOnPerAgent) {
  scene::Scene scene(named("free"));
  scene.add_body("mitten", "", nullptr, scene::kHead | scene::kEyes);
  const engine::ModelPtr model = compile(scene);
  ASSERT_EQ(model->nu, 9);
  EXPECT_EQ(model->njnt, free_room()->njnt) << "the joints stay";
  scene::Scene reach(named("reach"));
  reach.add_body("mitten", "", nullptr, scene::kLeftHand);
  EXPECT_EQ(compile(reach)->nu, 4) << "in place of the scene's own choice";
}

TEST(Recipes, HoldForEveryInfantByItsName) {
  scene::Scene scene(named("reach"));
  scene.add_body("mitten", "anna/", nullptr);
  const document::Pose beside{{0, 2, 0.35}, {1, 0, 0, 0}};
  scene.add_body("mitten", "ben/", &beside);
  const engine::ModelPtr model = compile(scene);
  EXPECT_EQ(model->nu, 16);
  EXPECT_EQ(model->neq, 2 * 53);
  EXPECT_GE(engine::find(*model, Kind::kBody, "anna/target"), 0);
  EXPECT_GE(engine::find(*model, Kind::kBody, "ben/target"), 0);
}

TEST(PositionControl, TakesJointsToTheirTargets) {
  const auto world = floating(kPosition);
  std::vector<float> actions(world->action_size());
  actions[action_index(*world, "act:right_elbow")] = -1.2f;
  actions[action_index(*world, "act:left_knee")] = -0.8f;
  run(*world, actions, 200);
  EXPECT_NEAR(angle(*world, "robot:right_elbow"), -1.2, 0.03);
  EXPECT_NEAR(angle(*world, "robot:left_knee"), -0.8, 0.03);
  EXPECT_NEAR(angle(*world, "robot:left_elbow"), 0, 0.03) << "the others hold as well";
  for (int i = 0; i < world->model().nu; ++i) EXPECT_EQ(world->data().ctrl[i], 0) << "motors rest";
}

TEST(PositionControl, BoundsAreTheRangesOfMotionAndTargetsAreSensed) {
  const auto world = floating(kPosition);
  const auto& actuation = *world->agents()[0].actuation;
  const std::size_t elbow = action_index(*world, "act:right_elbow");
  EXPECT_FLOAT_EQ(actuation.low()[elbow], static_cast<float>(-146 * M_PI / 180));
  EXPECT_FLOAT_EQ(actuation.high()[elbow], static_cast<float>(5 * M_PI / 180));
  Observation observation(*world);
  std::vector<float> actions(world->action_size());
  actions[elbow] = -9;
  world->step(actions, observation.data(), {});
  EXPECT_FLOAT_EQ(observation.at("proprioception/target", "act:right_elbow"), actuation.low()[elbow]) << "clipped";
  world->reset(nullptr, observation.data());
  EXPECT_EQ(observation.at("proprioception/target", "act:right_elbow"), 0) << "a reset holds the start";
}

TEST(PositionControl, StartsByHoldingTheStoredPose) {
  env::AgentOptions agent = blind();
  agent.actuation = kPosition;
  World world(room_with_infant("standup"), {agent}, without_renderer());
  const int lock = engine::find_lock(world.model(), joint_id(world, "robot:right_knee"));
  EXPECT_NEAR(engine::lock_angle(world.model(), lock), -2.53125, 1e-12);
  EXPECT_EQ((world.model().*compat::kLockFlags)[lock], 1);
}

TEST(MappedActions, GoFromMinusOneToOneLinearly) {
  const auto world = floating({actuation::Mode::kTorque, true});
  const auto& actuation = *world->agents()[0].actuation;
  for (std::size_t i = 0; i < world->action_size(); ++i) {
    EXPECT_EQ(actuation.low()[i], -1);
    EXPECT_EQ(actuation.high()[i], 1);
  }
  const std::size_t bend = action_index(*world, "act:hip_bend");  // -1 to 0.765
  const int motor = world->agents()[0].body.actuators[bend];
  for (const auto& [action, control] :
       std::vector<std::pair<float, double>>{{-1, -1}, {1, 0.765}, {0, -0.1175}, {3, 0.765}}) {
    std::vector<float> actions(world->action_size());
    actions[bend] = action;
    run(*world, actions, 1);
    EXPECT_NEAR(world->data().ctrl[motor], control, 1e-7);
  }
}

TEST(Locks, HoldAJointAndLetItGo) {
  const auto world = floating();
  const int elbow = joint_id(*world, "robot:right_elbow");
  set(*world, MIMO_JOINT_LOCK, {elbow}, {1, -1});
  std::vector<float> actions(world->action_size());
  actions[action_index(*world, "act:right_elbow")] = 0.3f;
  run(*world, actions, 300);
  EXPECT_NEAR(angle(*world, "robot:right_elbow"), -1, 0.1) << "against a third of its strength";
  world->reset(nullptr, nullptr);
  run(*world, {}, 100);
  EXPECT_NEAR(angle(*world, "robot:right_elbow"), -1, 0.02) << "locks outlive resets";
  set(*world, MIMO_JOINT_LOCK, {elbow}, Values{0, 0});
  run(*world, actions, 100);
  EXPECT_GT(angle(*world, "robot:right_elbow"), -0.1);
}

TEST(Locks, OpenLocksOfTheScene) {
  World world(room_with_infant("selfbody"), {blind()}, without_renderer());
  const int knee = joint_id(world, "robot:right_knee");
  run(world, {}, 50);
  EXPECT_NEAR(angle(world, "robot:right_knee"), -1.85, 0.02);
  set(world, MIMO_JOINT_LOCK, {knee}, Values{0, 0});
  run(world, {}, 50);
  EXPECT_GT(std::abs(angle(world, "robot:right_knee") + 1.85), 0.03);
}

TEST(Locks, AreRefusedWithoutLocks) {
  const auto world = floating();
  expect_error(Status::kUnsupported, "mimo_orientation", [&] {
    set(*world, MIMO_JOINT_LOCK, {joint_id(*world, "mimo_orientation")}, {1, 0});
  });
  expect_error(Status::kInvalidArgument, "from 0 to 47", [&] { set(*world, MIMO_JOINT_LOCK, {48}, {1, 0}); });
  const int elbow = joint_id(*world, "robot:right_elbow");
  expect_error(Status::kInvalidArgument, "angle is 2", [&] { set(*world, MIMO_JOINT_LOCK, {elbow}, {1, 2}); });
  expect_error(Status::kInvalidArgument, "values[1] is nan", [&] {
    set(*world, MIMO_JOINT_LOCK, {elbow}, {1, std::nan("")});
  });
  const auto positioned = floating(kPosition);
  expect_error(Status::kUnsupported, "under position control", [&] {
    set(*positioned, MIMO_JOINT_LOCK, {elbow}, {1, 0});
  });
  expect_error(Status::kUnsupported, "under position control", [&] {
    set(*positioned, MIMO_JOINT_LOCK, {elbow}, Values{0, 0});
  });
}

// Three worlds on one model: one is changed in every way, the other two stay alike.
TEST(Overrides, StayInTheirWorld) {
  const auto changed = floating(), one = floating(), two = floating();
  const int elbow = joint_id(*changed, "robot:right_elbow");
  set(*changed, MIMO_JOINT_LOCK, {elbow}, {1, -1});
  const std::int32_t motor = engine::find_or_fail(changed->model(), Kind::kActuator, "act:left_elbow");
  const double gear = 7.5;
  set(*changed, MIMO_ACTUATOR_GEAR, {motor}, {gear});
  changed->physics().set_gravity({0, 0, -1});
  EXPECT_EQ(get(*changed, MIMO_ACTUATOR_GEAR, {motor}), Values{gear});
  EXPECT_EQ(get(*one, MIMO_ACTUATOR_GEAR, {motor}), Values{3.6});
  EXPECT_EQ(((*free_room()).*compat::kLockFlags)[engine::find_lock(*free_room(), elbow)], 0);
  const std::vector<float> actions(changed->action_size(), 0.2f);
  run(*changed, actions, 20);
  run(*one, actions, 20);
  run(*two, actions, 20);
  for (int i = 0; i < one->model().nq; ++i) EXPECT_EQ(one->data().qpos[i], two->data().qpos[i]);
  EXPECT_LT(angle(*changed, "robot:right_elbow"), angle(*one, "robot:right_elbow") - 0.1);
  EXPECT_NE(angle(*changed, "robot:left_elbow"), angle(*one, "robot:left_elbow"));
}

TEST(Overrides, ShareUnchangedArrays) {
  const auto world = floating();
  EXPECT_EQ(world->model().eq_data, free_room()->eq_data);
  set(*world, MIMO_JOINT_LOCK, {joint_id(*world, "robot:right_elbow")}, {1, -1});
  EXPECT_NE(world->model().eq_data, free_room()->eq_data);
  EXPECT_EQ(world->model().actuator_gear, free_room()->actuator_gear);
  EXPECT_EQ(world->model().body_mass, free_room()->body_mass);
}

// How far the infant's centre of mass falls in ten physics steps of 5 ms. It is known as of the start of the last one,
// and MuJoCo adds up velocities first: after n steps it has fallen by g dt^2 n (n + 1) / 2.
double fall(World& world) {
  const int root = world.model().body_rootid[world.agents()[0].body.head];
  const double before = world.data().subtree_com[3 * root + 2];
  run(world, {}, 5);
  return before - world.data().subtree_com[3 * root + 2];
}

TEST(Gravity, PullsInOneWorld) {
  env::EnvOptions options = without_renderer();
  World moon(free_room(), {blind()}, options), earth(free_room(), {blind()}, options);
  moon.physics().set_gravity({0, 0, -1.62});
  constexpr double kSum = 0.005 * 0.005 * 9 * 10 / 2;
  const double on_moon = fall(moon), on_earth = fall(earth);
  EXPECT_NEAR(on_moon, 1.62 * kSum, 2e-6);  // joints at work move it, too, as steps are not endlessly short
  EXPECT_NEAR(on_earth - on_moon, (9.81 - 1.62) * kSum, 1e-12) << "by as much in both";
}

}  // namespace
}  // namespace mimo::test
