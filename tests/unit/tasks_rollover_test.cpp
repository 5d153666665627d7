// Rolling over: what is measured, how it starts, what random actions come to.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <random>

#include "base/numbers.h"
#include "engine/contacts.h"
#include "engine/model.h"
#include "support/block.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using env::World;

std::unique_ptr<World> world_of(const std::map<std::string, double>& parameters = {},
                                const std::string& body = "mitten") {
  static std::map<std::string, engine::ModelPtr> models;
  engine::ModelPtr& model = models[body];
  if (model == nullptr) model = room_with_infant("rollover", body);
  env::EnvOptions options = without_renderer();
  for (const auto& [name, value] : parameters) options.parameters.set(name, value);
  return std::make_unique<World>(model, std::vector<env::AgentOptions>{blind()}, options);
}

tasks::Task& task_of(const World& world) { return *world.agents()[0].task; }

double front_up(const mjData& data, const mjModel& model, const char* body) {
  return data.xmat[9 * engine::find_or_fail(model, Kind::kBody, body) + 6];
}

// The task's measure of an infant that lies on its back, turned by an angle about its long axis, head to -x.
double posture_at(double turn, const std::map<std::string, double>& parameters = {}, double twist = 0) {
  const auto world = world_of(parameters);
  world->reset(nullptr, nullptr);
  engine::Physics& physics = world->physics();
  physics.reset();
  mjData& data = physics.data();
  const mjModel& model = physics.model();
  const int root = engine::find_or_fail(model, Kind::kBody, "mimo_location");
  const Eigen::Quaterniond on_back(std::sqrt(0.5), 0, -std::sqrt(0.5), 0);
  const Eigen::Quaterniond now = on_back * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ());
  double* place = data.qpos + engine::free_joint_address(model, root);
  place[2] = 2;
  place[3] = now.w();
  place[4] = now.x();
  place[5] = now.y();
  place[6] = now.z();
  for (const char* joint : {"robot:hip_rot1", "robot:hip_rot2"}) {
    data.qpos[model.jnt_qposadr[engine::find_or_fail(model, Kind::kJoint, joint)]] = twist / 2;
  }
  physics.update_poses();
  double achieved = -1;
  task_of(*world).achieved(data, &achieved);
  return achieved;
}

TEST(Rollover, MeasuresHowFarTheHipHasTurned) {
  for (const double degrees : {0.0, 30.0, 90.0, 144.0, 180.0, -90.0, -144.0}) {
    EXPECT_NEAR(posture_at(degrees * kDegree), std::abs(degrees) / 180, 1e-7) << degrees;
  }
  // From the belly it is the rest of the way.
  EXPECT_NEAR(posture_at(kPi, {{"rollover/start", 1}}), 0, 1e-7);
  EXPECT_NEAR(posture_at(36 * kDegree, {{"rollover/start", 1}}), 0.8, 1e-7);
}

// A spine that is twisted by 20 degrees carries the chest that much further.
TEST(Rollover, OverTheChestItIsTheirMean) {
  EXPECT_NEAR(posture_at(90 * kDegree, {{"rollover/over_chest", 1}}, 20 * kDegree), (90 + 110) / 2.0 / 180, 1e-6);
  EXPECT_NEAR(posture_at(90 * kDegree, {}, 20 * kDegree), 0.5, 1e-7) << "the hip's alone";
}

// The head, a sphere of 7.35 cm whose middle is 1 cm before the root, reaches down furthest.
TEST(Rollover, StartsOnTheFloor) {
  for (const std::string body : {"mitten", "fingers"}) {
    const auto world = world_of({}, body);
    world->physics().reset();
    world->physics().update_poses();
    EXPECT_NEAR(body::extent(world->model(), world->data(), world->agents()[0].body).low, 0, 1e-9) << body;
  }
}

TEST(Rollover, StartsOnTheBackOrTheBelly) {
  for (const std::string body : {"mitten", "fingers"}) {
    for (const int start : {0, 1}) {
      const auto world = world_of({{"rollover/start", start}}, body);
      const std::uint64_t seed = 3;
      world->reset(&seed, nullptr);
      const double up = start == 0 ? 1 : -1;
      for (const char* part : {"hip", "upper_body"}) {
        EXPECT_GT(up * front_up(world->data(), world->model(), part), std::cos(20 * kDegree)) << body << part << start;
      }
      const body::Extent extent = body::extent(world->model(), world->data(), world->agents()[0].body);
      EXPECT_NEAR(extent.low, 0, 0.005) << "lies on the floor";
      EXPECT_LT(extent.high, 0.25);
      double achieved = -1;
      task_of(*world).achieved(world->data(), &achieved);
      EXPECT_LT(achieved, 0.1);
    }
  }
}

TEST(Rollover, DrawsWhereItStarts) {
  const auto world = world_of({{"rollover/start", 2}});
  int on_back = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    world->reset(&seed, nullptr);
    on_back += front_up(world->data(), world->model(), "hip") > 0;
  }
  EXPECT_GT(on_back, 10);
  EXPECT_LT(on_back, 30);  // 20 with a standard deviation of 3.2
}

TEST(Rollover, RewardsPostureMinusEffort) {
  const auto world = world_of();
  world->reset(nullptr, nullptr);
  double reward = 0, achieved = -1, goal = -1;
  world->step(std::vector<float>(world->action_size(), 0.5f), nullptr, {{&reward, 1}, {}, {}});
  task_of(*world).achieved(world->data(), &achieved);
  task_of(*world).goal(world->data(), &goal);
  double effort = 0;
  for (int motor = 0; motor < world->model().nu; ++motor) effort += std::pow(world->data().ctrl[motor], 2);
  EXPECT_GT(effort, 1);
  EXPECT_NEAR(reward, achieved - 0.01 * effort, 1e-12);
  EXPECT_EQ(goal, 0.8);
}

struct Played {
  double best = 0;
  bool success = false, terminated = false, truncated = false;
  int steps = 0;
};

template <typename Policy>
Played play(World& world, std::uint64_t seed, Policy&& policy) {
  world.reset(&seed, nullptr);
  Played played;
  while (!played.terminated && !played.truncated && played.steps < 2000) {
    std::uint8_t terminated = 0, truncated = 0;
    world.step(policy(world), nullptr, {{}, {&terminated, 1}, {&truncated, 1}});
    double achieved = 0;
    task_of(world).achieved(world.data(), &achieved);
    played.best = std::max(played.best, achieved);
    played.success = played.success || task_of(world).outcome() == tasks::Outcome::kSuccess;
    played.terminated = terminated == 1;
    played.truncated = truncated == 1;
    ++played.steps;
  }
  return played;
}

TEST(Rollover, RandomActionsDoNotTurnItOver) {
  for (const int start : {0, 1}) {
    const auto world = world_of({{"rollover/start", start}});
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      std::mt19937 random(static_cast<unsigned>(seed));
      std::uniform_real_distribution<float> uniform(-1, 1);
      const Played played = play(*world, seed, [&](const World& w) {
        std::vector<float> actions(w.action_size());
        for (float& action : actions) action = uniform(random);
        return actions;
      });
      EXPECT_FALSE(played.success) << played.best;
      EXPECT_TRUE(played.truncated);
      EXPECT_EQ(played.steps, 1000);
    }
  }
}

// Pushed over by a torque about its long axis, it has turned over, and the episode goes on or not, as it was told.
TEST(Rollover, TurningOverIsASuccess) {
  for (const int ends : {0, 1}) {
    const auto world = world_of({{"rollover/ends_on_success", ends}});
    const Played played = play(*world, 0, [&](World& w) {
      double* torque = w.physics().data().xfrc_applied + 6 * engine::find_or_fail(w.model(), Kind::kBody, "hip") + 3;
      torque[0] = task_of(w).outcome() == tasks::Outcome::kSuccess ? 0 : 12;
      return std::vector<float>(w.action_size());
    });
    EXPECT_TRUE(played.success) << played.best;
    EXPECT_EQ(played.terminated, ends == 1);
  }
}

// A state knows on which side the episode began.
TEST(Rollover, StatesGoOnWhereTheyWereTaken) {
  const auto one = world_of({{"rollover/start", 2}});
  const auto other = world_of({{"rollover/start", 2}});
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    one->reset(&seed, nullptr);
    std::vector<std::uint8_t> state(one->state_bytes());
    one->save(state);
    other->load(state);
    double mine = 0, theirs = 0;
    const std::vector<float> actions(one->action_size(), 0.2f);
    one->step(actions, nullptr, {{&mine, 1}, {}, {}});
    other->step(actions, nullptr, {{&theirs, 1}, {}, {}});
    EXPECT_EQ(mine, theirs);
  }
}

}  // namespace
}  // namespace mimo::test
