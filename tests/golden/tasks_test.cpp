// Rewards of the tasks, given the positions that the original's rewards used; stored poses and where resets lead.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "support/block.h"
#include "support/numbers.h"
#include "support/recording.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

using engine::Kind;
using World = env::World;

constexpr Tolerance kExact = {0, 1e-9};

std::unique_ptr<World> world_of(const std::string& scene, const tasks::Settings& parameters = {}) {
  env::EnvOptions options = without_renderer();
  options.parameters = parameters;
  return std::make_unique<World>(room_with_infant(scene), std::vector<env::AgentOptions>{blind()}, options);
}

int body_id(const World& world, const std::string& name) {
  return engine::find_or_fail(world.model(), Kind::kBody, name);
}

void put_bodies(World& world, const Json& positions) {
  for (const auto& [name, place] : positions.items()) {
    const std::vector<double> xyz = place;
    std::copy(xyz.begin(), xyz.end(), world.physics().data().xpos + 3 * body_id(world, name));
  }
}

tasks::Task& task_of(const World& world) { return *world.agents()[0].task; }

// The ball where the original's episode had it.
tasks::Settings original_reach(const std::vector<double>& target) {
  const double scene[3] = {0.3, -0.05, 0.7};
  const char axes[] = "xyz";
  tasks::Settings settings;
  settings.set("reach/original_rules", 1);
  settings.set("reach/warm_up_steps", 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = std::string("reach/target_") + axes[i];
    settings.set(name + "_low", target[i] - scene[i]);
    settings.set(name + "_high", target[i] - scene[i]);
  }
  return settings;
}

TEST(GoldenReach, RewardsByTheOriginalsRules) {
  const Json rows = read_json("rewards_reach.json");
  const auto world = world_of("reach", original_reach(rows[0].at("target_init_pos")));
  world->reset(nullptr, nullptr);
  int successes = 0;
  for (const Json& row : rows) {
    SCOPED_TRACE(row.at("k").dump());
    put_bodies(*world, row.at("xpos_used"));
    task_of(*world).evaluate(world->physics());
    EXPECT_TRUE(close(row.at("reward"), task_of(*world).reward(), kExact));
    EXPECT_EQ(task_of(*world).outcome() == tasks::Outcome::kSuccess, row.at("is_success").get<bool>());
    EXPECT_EQ(task_of(*world).over(), row.at("terminated").get<bool>());
    successes += task_of(*world).outcome() == tasks::Outcome::kSuccess ? 1 : 0;
  }
  EXPECT_EQ(successes, 11);
}

TEST(GoldenReach, HeadFollowsAsInTheOriginal) {
  const auto world = world_of("reach");
  const std::vector<std::string> followed = {"robot:head_swivel", "robot:head_tilt", "robot:head_tilt_side",
                                             "robot:left_eye_horizontal", "robot:right_eye_horizontal"};
  for (const Json& row : read_json("rewards_reach.json")) {
    SCOPED_TRACE(row.at("k").dump());
    set_positions(world->model(), row.at("qpos"), world->physics().data().qpos);
    world->physics().forward();
    task_of(*world).follow(world->physics());
    for (const std::string& name : followed) {
      const int joint = engine::find_or_fail(world->model(), Kind::kJoint, name);
      // The original looked from where the head had been a step before; every tenth step the ball was pushed.
      EXPECT_TRUE(close(row.at("qpos").at(name)[0], world->data().qpos[world->model().jnt_qposadr[joint]], {0, 5e-3}))
          << name;
    }
  }
}

TEST(GoldenStandup, Rewards) {
  const auto world = world_of("standup");
  for (const Json& row : read_json("rewards_standup.json")) {
    SCOPED_TRACE(row.at("k").dump());
    const std::vector<double> controls = row.at("ctrl");
    ASSERT_EQ(static_cast<int>(controls.size()), world->model().nu);
    std::copy(controls.begin(), controls.end(), world->physics().data().ctrl);
    put_bodies(*world, row.at("xpos_used"));
    task_of(*world).evaluate(world->physics());
    EXPECT_TRUE(close(row.at("reward"), task_of(*world).reward(), kExact));
    EXPECT_EQ(task_of(*world).outcome() == tasks::Outcome::kSuccess, row.at("is_success").get<bool>());
    EXPECT_FALSE(task_of(*world).over());
  }
}

// Tries seeds until a body is the target.
void aim_at(World& world, const std::string& target) {
  Observation observation(world);
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    world.reset(&seed, observation.data());
    if (observation.at("task/target", target) == 1) return;
  }
  FAIL() << target << " is never the target";
}

// The original measured to a wrong body; the true distance is checked against the formula. A reward belongs to the
// contacts of the state before, which is the row before.
TEST(GoldenSelfbody, Rewards) {
  const Json rows = read_json("rewards_selfbody.json");
  const auto world = world_of("selfbody");
  int compared = 0, distances = 0, felt_more = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const Json& row = rows[k];
    if (rows[k - 1].at("target_body_id") != row.at("target_body_id")) continue;  // another episode began
    SCOPED_TRACE(row.at("k").dump());
    aim_at(*world, row.at("target_body_true"));
    set_positions(world->model(), rows[k - 1].at("qpos"), world->physics().data().qpos);
    world->physics().forward();
    task_of(*world).watch(world->physics());
    task_of(*world).evaluate(world->physics());
    const double reward = task_of(*world).reward();
    ++compared;
    if (row.at("reward").get<double>() == -1) {
      // The original did not feel forces without a positive component.
      if (reward != -1) ++felt_more;
      continue;
    }
    ++distances;
    const std::vector<double> fingers = row.at("xpos_used").at("right_fingers");
    const double* head = world->data().xpos + 3 * body_id(*world, "head");
    const double distance = std::hypot(fingers[0] - head[0], fingers[1] - head[1], fingers[2] - head[2]);
    EXPECT_NEAR(reward, -distance, 1e-3);
  }
  EXPECT_EQ(compared, 63);
  EXPECT_EQ(distances, 3);
  EXPECT_LE(felt_more, 4) << "fingers that touch for a step or two around those three";
}

// The scene gives its infant a coarse skin on thirteen bodies. Points of one geom inside of another are left out, by us
// by the shapes themselves and by the original by meshes inscribed in them, which reach less far: with sensors this far
// apart the difference is up to an eighth.
TEST(GoldenSelfbody, Skin) {
  const auto world = world_of("selfbody");
  const mjModel& model = world->model();
  std::map<int, int> counts;
  for (const auto& sensor : world->agents()[0].skin->sensors()) ++counts[sensor.body];
  const std::map<std::string, int> expected = read_json("touch_counts.json").at("selfbody");
  ASSERT_EQ(counts.size() + 1, expected.size()) << "each body, and the total";
  int whole = 0;
  for (const auto& [body, count] : counts) {
    const std::string name = engine::name(model, Kind::kBody, body);
    SCOPED_TRACE(name);
    ASSERT_EQ(expected.count(name), 1u);
    EXPECT_LE(count, expected.at(name));
    EXPECT_GE(count, 7 * expected.at(name) / 8);
    if (model.body_geomnum[body] > 1) continue;
    EXPECT_EQ(count, expected.at(name)) << "nothing to be left out";
    ++whole;
  }
  EXPECT_GE(whole, 4);
}

class GoldenPose : public ::testing::TestWithParam<const char*> {};

TEST_P(GoldenPose, IsStored) {
  const auto world = world_of(GetParam());
  const Json recorded = read_json("poses.json").at(GetParam());
  expect_positions(world->model(), recorded.at("stored"), world->data().qpos, {0, 1e-6});
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenPose, ::testing::Values("reach", "standup", "selfbody"),
                         [](const auto& scene) { return std::string(scene.param); });

// Locks, couplings and weight pull the stored pose to the one that the original starts from.
TEST(GoldenSelfbody, Settles) {
  const auto world = world_of("selfbody");
  world->reset(nullptr, nullptr);
  const Json recorded = MIMO_MUJOCO_4 ? read_json("mujoco4/settled.json")
                                      : read_json("poses.json").at("selfbody").at("after_construction");
  expect_positions(world->model(), recorded, world->data().qpos, {0, 1e-5});
  for (int i = 0; i < world->model().nv; ++i) EXPECT_EQ(world->data().qvel[i], 0);
}

}  // namespace
}  // namespace mimo::test
