// Tasks with infants of other ages: what scales with them, and that an episode runs.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>

#include "base/format.h"
#include "base/numbers.h"
#include "engine/model.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using Eigen::Vector3d;
using engine::Kind;
using env::World;

engine::ModelPtr model_of(const std::string& room, double age) {
  static std::map<std::pair<std::string, double>, engine::ModelPtr> models;
  engine::ModelPtr& model = models[{room, age}];
  if (model != nullptr) return model;
  scene::Scene scene(named(room));
  scene.add_body(scene.usual_infant().body, "", nullptr);
  growth::Growth growth;
  growth.age = growth.physiological_age = age;
  scene.grow("", growth);
  return model = compile(scene);
}

std::unique_ptr<World> world_of(const std::string& room, double age) {
  env::AgentOptions agent = blind();
  if (room == "catch") agent.actuation.mode = actuation::Mode::kMuscle;
  return std::make_unique<World>(model_of(room, age), std::vector<env::AgentOptions>{agent}, without_renderer());
}

tasks::Task& task_of(const World& world) { return *world.agents()[0].task; }

int id_of(const mjModel& model, const std::string& body) { return engine::find_or_fail(model, Kind::kBody, body); }

Vector3d place_of(const World& world, const std::string& body) {
  return Eigen::Map<const Vector3d>(world.data().xpos + 3 * id_of(world.model(), body));
}

// Where a body is before anything has moved.
Vector3d start_of(const engine::ModelPtr& model, const std::string& body) {
  engine::Physics physics(model, {});
  return Eigen::Map<const Vector3d>(physics.data().xpos + 3 * id_of(*model, body));
}

// From shoulder to wrist, of the joints' places.
double arm_of(const mjModel& model) {
  return model.body_pos[3 * id_of(model, "right_lower_arm") + 2] + model.body_pos[3 * id_of(model, "right_hand") + 2];
}

// Standing, of an infant that stands straight in an empty room.
double stature_of(double age) {
  const engine::ModelPtr model = model_of("free", age);
  engine::Physics physics(model, {});
  physics.reset();
  for (int joint = 0; joint < model->njnt; ++joint) {
    if (model->jnt_type[joint] == mjJNT_HINGE) physics.data().qpos[model->jnt_qposadr[joint]] = 0;
  }
  physics.update_poses();
  const body::Extent extent = body::extent(*model, physics.data(), body::find_body(*model, ""));
  return extent.high - extent.low;
}

double goal_of(const World& world) {
  double goal = -1;
  task_of(world).goal(world.data(), &goal);
  return goal;
}

class TaskAges : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Ages, TaskAges, testing::Values(0.0, 6.0, 12.0, 24.0),
                         [](const auto& test) { return format("{:g}", test.param); });

TEST_P(TaskAges, EveryTaskRuns) {
  for (const std::string room :
       {"reach", "standup", "selfbody", "catch", "rollover", "babybench-crib", "babybench-cubes"}) {
    const auto world = world_of(room, GetParam());
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      world->reset(&seed, nullptr);
      for (int i = 0; i < 100; ++i) {
        double reward = std::nan("");
        std::uint8_t over = 0;
        std::vector<float> actions(world->action_size());
        for (std::size_t k = 0; k < actions.size(); ++k)
          actions[k] = static_cast<float>(std::sin(0.1 * i + 2 * static_cast<double>(k)));
        world->step(actions, nullptr, {{&reward, 1}, {&over, 1}, {}});
        ASSERT_TRUE(std::isfinite(reward)) << room;
        if (over == 1) break;
      }
    }
  }
}

// The ball is so many arm's lengths from the shoulder, and so is the box that its place is drawn from.
TEST_P(TaskAges, ReachHasTheBallAsFarAsTheArmIsLong) {
  const engine::ModelPtr born = model_of("reach", 18), grown = model_of("reach", GetParam());
  const double ratio = arm_of(*grown) / arm_of(*born);
  const Vector3d from_shoulder = start_of(grown, "target") - start_of(grown, "right_upper_arm");
  const Vector3d was = start_of(born, "target") - start_of(born, "right_upper_arm");
  EXPECT_LT((from_shoulder - ratio * was).norm(), 1e-6);
  const auto world = world_of("reach", GetParam());
  const Vector3d low(-0.1, -0.2, -0.1), high(0, 0.1, 0), start = start_of(grown, "target");
  Vector3d lowest = Vector3d::Constant(1), highest = -lowest;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    world->reset(&seed, nullptr);
    const Vector3d moved = (place_of(*world, "target") - start) / ratio;
    lowest = lowest.cwiseMin(moved);
    highest = highest.cwiseMax(moved);
  }
  EXPECT_TRUE(((lowest - low).array() > -1e-6).all() && ((high - highest).array() > -1e-6).all());
  EXPECT_TRUE(((highest - lowest).array() > 0.8 * (high - low).array()).all()) << "of 40 draws";
}

TEST_P(TaskAges, StandupHasARailToItsSize) {
  const double ratio = stature_of(GetParam()) / stature_of(18);
  const auto world = world_of("standup", GetParam());
  EXPECT_NEAR(goal_of(*world), 0.5 * ratio, 1e-6);
  const std::uint64_t seed = 0;
  world->reset(&seed, nullptr);
  EXPECT_NEAR(place_of(*world, "crib").z(), 0.42 * ratio, 1e-6);
  for (const char* side : {"left", "right"}) {
    EXPECT_NEAR(place_of(*world, format("{}_fingers", side)).z(), 0.45 * ratio, 0.02) << "holds the rail";
    EXPECT_NEAR(place_of(*world, format("{}_foot", side)).z(), 0, 0.02) << "stands on the floor";
  }
  EXPECT_LT(place_of(*world, "head").z(), goal_of(*world)) << "does not stand yet";
}

// Knees and hips straightened as far as its muscles can.
TEST(TaskSizes, OldInfantsStandUp) {
  for (const auto& [age, stands] : std::map<double, bool>{{0, false}, {18, true}, {24, true}}) {
    const auto world = world_of("standup", age);
    std::vector<float> actions(world->action_size());
    for (std::size_t i = 0; i < actions.size(); ++i) {
      const std::string name = world->agents()[0].actuation->names()[i];
      if (name.find("knee") != std::string::npos || name.find("hip_flex") != std::string::npos) actions[i] = 1;
    }
    const std::uint64_t seed = 0;
    world->reset(&seed, nullptr);
    bool success = false;
    for (int i = 0; i < 500; ++i) {
      world->step(actions, nullptr, {});
      success = success || task_of(*world).outcome() == tasks::Outcome::kSuccess;
    }
    EXPECT_EQ(success, stands) << age;
  }
}

// A ball falls onto the hand, which does nothing, at any size.
TEST_P(TaskAges, CatchHasABallForTheHand) {
  const double ratio = arm_of(*model_of("catch", GetParam())) / arm_of(*model_of("catch", 18));
  const auto world = world_of("catch", GetParam());
  const int ball = world->model().body_geomadr[id_of(world->model(), "target")];
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    world->reset(&seed, nullptr);
    const double radius = world->model().geom_size[3 * ball];
    EXPECT_GE(radius, 0.005 * ratio);
    EXPECT_LE(radius, 0.025 * ratio);
    EXPECT_GE(world->model().body_mass[id_of(world->model(), "target")], 0.05 * std::pow(ratio, 3));
    EXPECT_LE(world->model().body_mass[id_of(world->model(), "target")], 0.5 * std::pow(ratio, 3));
    bool touched = false;
    for (int i = 0; i < 100 && !touched; ++i) {
      world->step(std::vector<float>(world->action_size()), nullptr, {});
      touched = task_of(*world).terms()[0].value > 0;
    }
    EXPECT_TRUE(touched) << seed;
  }
}

TEST_P(TaskAges, SelfbodySitsOnTheFloor) {
  const auto world = world_of("selfbody", GetParam());
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    world->reset(&seed, nullptr);
    const double before = place_of(*world, "head").z();
    for (int i = 0; i < 200; ++i) world->step(std::vector<float>(world->action_size()), nullptr, {});
    EXPECT_NEAR(place_of(*world, "head").z(), before, 0.01) << "stays seated";
    EXPECT_NEAR(body::extent(world->model(), world->data(), world->agents()[0].body).low, 0, 0.01);
  }
}

TEST_P(TaskAges, RolloverLiesOnTheFloor) {
  const auto world = world_of("rollover", GetParam());
  world->reset(nullptr, nullptr);
  double achieved = -1;
  task_of(*world).achieved(world->data(), &achieved);
  EXPECT_LT(achieved, 0.1);
  EXPECT_NEAR(body::extent(world->model(), world->data(), world->agents()[0].body).low, 0, 0.005);
}

TEST(TaskSizes, DocumentsWithInvalidGrowthAreRefused) {
  for (const std::string numbers : {"6 0.8", "6 0 0.8", "6 0.8 -1", "6 0.8 0.8 0.8"}) {
    const engine::ModelPtr model = compiled("<mujoco><custom><numeric name='mimo:growth' data='" + numbers +
                                            "'/></custom><worldbody><body name='mimo_location'><geom size='.1'/>"
                                            "<body name='head'><geom size='.1'/></body></body></worldbody></mujoco>");
    expect_error(Status::kModel, "numeric mimo:growth: expected three numbers", [&] { body::find_body(*model, ""); });
  }
}

}  // namespace
}  // namespace mimo::test
