// Behaviours in the built-in scenes: how they start, what they measure there, when they succeed, what is refused.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "body/body.h"
#include "engine/contacts.h"
#include "engine/overrides.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace mimo::test {
namespace {

using env::World;

constexpr const char* kBehaviours[] = {"head-lift",
                                       "chest-lift",
                                       "roll-to-belly",
                                       "roll-to-back",
                                       "sit-with-hands",
                                       "sit",
                                       "sit-up",
                                       "hands-and-knees",
                                       "crawl",
                                       "pull-to-stand",
                                       "stand-with-support",
                                       "stand",
                                       "cruise",
                                       "walk-with-help",
                                       "walk",
                                       "hand-to-mouth",
                                       "hands-together",
                                       "foot-grasp",
                                       "reach-moving",
                                       "lift",
                                       "bang",
                                       "drop",
                                       "follow",
                                       "prefer",
                                       "mobile"};

struct Options {
  double age = 18;
  std::string body{};  // "": the scene's own
  std::map<std::string, double> parameters{};
};

std::unique_ptr<World> world_of(const std::string& room, const Options& options = {}) {
  scene::Scene scene(named(room));
  scene.add_body(options.body.empty() ? scene.usual_infant().body : options.body, "", nullptr);
  if (options.age != 18) {
    growth::Growth growth;
    growth.age = growth.physiological_age = options.age;
    scene.grow("", growth);
  }
  env::EnvOptions world = without_renderer();
  for (const auto& [name, value] : options.parameters) world.parameters.set(name, value);
  auto made = std::make_unique<World>(compile(scene), std::vector<env::AgentOptions>{blind()}, world);
  const std::uint64_t seed = 1;
  made->reset(&seed, nullptr);
  return made;
}

tasks::Task& task_of(const World& world) { return *world.agents()[0].task; }

std::vector<double> goal(const World& world) {
  std::vector<double> numbers(static_cast<std::size_t>(task_of(world).goal_size()));
  task_of(world).goal(world.data(), numbers.data());
  return numbers;
}

std::vector<double> achieved(const World& world) {
  std::vector<double> numbers(static_cast<std::size_t>(task_of(world).goal_size()));
  task_of(world).achieved(world.data(), numbers.data());
  return numbers;
}

void step(World& world) { world.step(std::vector<float>(world.action_size()), nullptr, {}); }

// All joints stay where they are.
void freeze(World& world) {
  for (const body::Joint& joint : world.agents()[0].body.joints) {
    const int lock = engine::find_lock(world.model(), joint.id);
    if (lock >= 0) world.physics().hold(lock, world.data().qpos[joint.qpos]);
  }
}

class Behaviours : public ::testing::TestWithParam<const char*> {};

TEST_P(Behaviours, StartUnreachedAndMeasureNumbers) {
  const auto world = world_of(GetParam());
  EXPECT_EQ(world->task_name(), "behaviour");
  EXPECT_NE(task_of(*world).outcome(), tasks::Outcome::kSuccess);
  for (const double number : achieved(*world)) EXPECT_TRUE(std::isfinite(number));
  for (int i = 0; i < 20; ++i) step(*world);
  EXPECT_NE(task_of(*world).outcome(), tasks::Outcome::kSuccess) << "nothing was done";
  EXPECT_LE(task_of(*world).terms()[0].value, 1);
  EXPECT_GE(task_of(*world).terms()[0].value, 0);
}

// Half a centimetre is what the library does not warn of: an infant that lies sinks in by less.
TEST_P(Behaviours, StartInsideOfNothing) {
  const auto world = world_of(GetParam(), {18, "", {{"behaviour/pose_noise", 0}}});
  const engine::Overlap overlap = engine::deepest_overlap(world->model(), world->data(), world->agents()[0].body.root);
  EXPECT_LT(overlap.depth, 0.005) << engine::name(world->model(), engine::Kind::kBody, overlap.met.bodies[0]) << ", "
                                  << engine::name(world->model(), engine::Kind::kBody, overlap.met.bodies[1]);
}

INSTANTIATE_TEST_SUITE_P(All, Behaviours, ::testing::ValuesIn(kBehaviours), [](const auto& scene) {
  std::string name = scene.param;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
});

// WHO: sits straight, the head erect, without arms or hands, for 10 seconds. A body whose joints do not move sits as
// long as one likes.
TEST(Sit, TenSecondsAreASuccess) {
  const auto world = world_of("sit");
  freeze(*world);
  int steps = 0;
  while (task_of(*world).outcome() != tasks::Outcome::kSuccess && steps < 1400) {
    step(*world);
    ++steps;
  }
  EXPECT_GE(steps, 1000) << "of 10 ms";
  EXPECT_LT(steps, 1100);
  EXPECT_NEAR(achieved(*world).back(), 10, 0.011) << "the longest time for which all held";
}

TEST(Sit, AThresholdAndATimeOfOnesOwn) {
  const auto world = world_of("sit", {18, "", {{"behaviour/threshold", 60}, {"behaviour/hold_seconds", 1}}});
  EXPECT_EQ(goal(*world).front(), 60);
  EXPECT_EQ(goal(*world).back(), 1);
  freeze(*world);
  for (int i = 0; i < 120; ++i) step(*world);
  EXPECT_EQ(task_of(*world).outcome(), tasks::Outcome::kSuccess);
}

TEST(Sit, AnEpisodeEndsAfterItsSeconds) {
  const auto world = world_of("sit", {18, "", {{"behaviour/episode_seconds", 0.5}}});
  for (int i = 0; i < 49; ++i) step(*world);
  EXPECT_FALSE(world->over());
  step(*world);
  EXPECT_TRUE(world->over()) << "0.5 s are 50 steps of 10 ms";
}

// Lengths are scaled with stature, angles and seconds are not.
TEST(Stand, ThresholdsAreThoseOfTheBodysSize) {
  const auto grown = world_of("stand"), infant = world_of("stand", {9});
  const double stature = infant->agents()[0].body.stature;
  EXPECT_LT(stature, 0.95);
  EXPECT_NEAR(goal(*infant)[0], stature * goal(*grown)[0], 1e-9);
  EXPECT_EQ(goal(*infant)[3], goal(*grown)[3]);
  EXPECT_EQ(goal(*infant)[4], goal(*grown)[4]);
}

template <typename Make>
std::string refusal(Make&& make) {
  try {
    make();
  } catch (const Error& error) {
    return error.message();
  }
  return "taken";
}

// A newborn's hips stretch to -30 degrees only (tests/unit/growth), and standing wants -7.
TEST(Stand, IsImpossibleForNewborns) {
  const std::string said = refusal([] { world_of("stand", {0}); });
  EXPECT_NE(said.find("age is 0 months"), std::string::npos) << said;
  EXPECT_NE(said.find("hip1"), std::string::npos) << said;
  EXPECT_EQ(refusal([] { world_of("head-lift", {0}); }), "taken");
}

TEST(Lift, MittensDoNotGrasp) {
  const std::string said = refusal([] { world_of("lift", {18, "mitten"}); });
  EXPECT_NE(said.find("body \"mitten\": the scene is made for fingers only"), std::string::npos) << said;
}

TEST(Behaviour, NeedsASceneThatSaysWhatIsMeasured) {
  env::EnvOptions options = without_renderer();
  options.task = "behaviour";
  const std::string said = refusal([&] { World world(room_with_infant("free"), {blind()}, options); });
  EXPECT_NE(said.find("custom text \"mimo:reached\""), std::string::npos) << said;
}

// What a lab writes: the thirtieth behaviour needs no C++.
TEST(Behaviour, IsComposedInADocument) {
  scene::Scene scene(from_text(
      "<mujoco><include file='mimo/parts/room.xml'/><custom><numeric name='mimo:place' data='0 0 0.36 1 0 0 0'/>"
      "<text name='mimo:task' data='behaviour'/><numeric name='mimo:episode_seconds' data='2'/>"
      "<text name='mimo:reached' data='height head at most 0.3 from 0.6 m; for 0.1 s'/></custom></mujoco>"));
  scene.add_body("mitten", "", nullptr);
  World world(compile(scene), {blind()}, without_renderer());
  const std::uint64_t seed = 1;
  world.reset(&seed, nullptr);
  int steps = 0;
  while (task_of(world).outcome() != tasks::Outcome::kSuccess && steps < 200) {
    step(world);
    ++steps;
  }
  EXPECT_GT(steps, 30) << "a head that starts at 0.66 m falls 0.36 m in 0.27 s at least (g t^2 / 2)";
  EXPECT_LT(steps, 200) << "an infant that nobody moves falls down";
}

// A scene of its own with the mitten infant, which stands with its head at 0.66 m and falls.
std::unique_ptr<World> world_that_reads(const std::string& reached, const std::string& more = "",
                                        const std::map<std::string, double>& parameters = {}, int frame_skip = 0) {
  scene::Scene scene(from_text(
      "<mujoco><include file='mimo/parts/room.xml'/><custom><numeric name='mimo:place' data='0 0 0.36 1 0 0 0'/>"
      "<text name='mimo:task' data='behaviour'/>" +
      more + "<text name='mimo:reached' data='" + reached + "'/></custom></mujoco>"));
  scene.add_body("mitten", "", nullptr);
  env::EnvOptions options = without_renderer();
  for (const auto& [name, value] : parameters) options.parameters.set(name, value);
  if (frame_skip != 0) options.frame_skip = frame_skip;
  auto world = std::make_unique<World>(compile(scene), std::vector<env::AgentOptions>{blind()}, options);
  const std::uint64_t seed = 1;
  world->reset(&seed, nullptr);
  return world;
}

TEST(Behaviour, AThresholdBeforeTheBeginOfProgressIsAllOrNothing) {
  const auto world = world_that_reads("height head at least 0.5 from 0.2 m", "", {{"behaviour/threshold", 0.1}});
  step(*world);
  EXPECT_EQ(task_of(*world).terms()[0].value, 1) << "the head is above 0.1 m";
}

// One step of 400 physics steps: the head falls through the band on the way and is below it at the end.
TEST(Behaviour, ASuccessWithinAStepCounts) {
  for (const std::string hold : {"", "; for 0.02 s"}) {
    const std::string band = "height head at most 0.6 m; height head at least 0.5 m";
    const auto world = world_that_reads(band + hold, "", {}, 400);
    step(*world);
    EXPECT_LT(achieved(*world)[1], 0.5) << "it has fallen through";
    EXPECT_GE(achieved(*world).back(), 0.02);
    EXPECT_EQ(task_of(*world).outcome(), tasks::Outcome::kSuccess) << band << hold;
    EXPECT_EQ(task_of(*world).terms()[1].value, 0) << "it does not hold where the step ends";
    step(*world);
    EXPECT_EQ(task_of(*world).outcome(), tasks::Outcome::kNone) << "that was in the step before";
  }
  const auto too_long = world_that_reads("height head at most 0.6 m; height head at least 0.5 m; for 1 s", "", {}, 400);
  step(*too_long);
  EXPECT_EQ(task_of(*too_long).outcome(), tasks::Outcome::kNone);
}

// A movement has no evaluation of its own: the next step's tells what was reached in it, from a state as well.
TEST(Behaviour, ASuccessOfAMovementIsToldByTheNextStep) {
  const auto world = world_that_reads("height head at most 0.6 m; height head at least 0.5 m", "", {}, 3);
  const auto nq = static_cast<std::size_t>(world->model().nq);
  const auto* root = std::find(world->model().jnt_type, world->model().jnt_type + world->model().njnt, mjJNT_FREE);
  const int at = world->model().jnt_qposadr[root - world->model().jnt_type];
  std::vector<double> positions;
  for (const double lower : {0.1, 0.0, 0.0}) {
    positions.insert(positions.end(), world->data().qpos, world->data().qpos + nq);
    positions[positions.size() - nq + static_cast<std::size_t>(at) + 2] -= lower;
  }
  world->follow(positions, {}, nullptr);
  EXPECT_GT(achieved(*world)[0], 0.6) << "it is up again";
  const Bytes state = saved(*world);
  for (int i = 0; i < 2; ++i) {
    step(*world);
    EXPECT_EQ(task_of(*world).outcome(), tasks::Outcome::kSuccess) << (i == 0 ? "at once" : "from a state");
    load(*world, state);
  }
}

TEST(Behaviour, RefusesWhatIsNoTime) {
  const auto said = [](const std::string& entry) {
    return refusal([&] { world_that_reads("height head at most 0.3 m", "<numeric name='mimo:" + entry + "/>"); });
  };
  for (const char* wrong : {"episode_seconds' data='0'", "episode_seconds' data='-1'",
                            "episode_seconds' size='2' data='0.05'", "phases' data='1 0'"}) {
    EXPECT_NE(said(wrong).find("expected"), std::string::npos) << wrong << ": " << said(wrong);
  }
  EXPECT_EQ(said("episode_seconds' data='0.05'"), "taken");
}

// The mobile is held for 120 s, then kicks move it.
TEST(Mobile, MovesInItsSecondPhase) {
  const auto world = world_of("mobile");
  const int joint = engine::find_or_fail(world->model(), engine::Kind::kJoint, "mobile_swing");
  const int lock = engine::find_lock(world->model(), joint);
  EXPECT_TRUE(engine::is_held(world->model(), lock));
  for (int i = 0; i < 12001; ++i) step(*world);
  EXPECT_FALSE(engine::is_held(world->model(), lock)) << "120 s are 12000 steps of 10 ms";
}

TEST(Behaviour, GoesOnFromAStateToTheBit) {
  const auto world = world_of("crawl");
  for (int i = 0; i < 30; ++i) step(*world);
  const Bytes state = saved(*world);
  for (int i = 0; i < 30; ++i) step(*world);
  const std::vector<double> there = achieved(*world);
  load(*world, state);
  for (int i = 0; i < 30; ++i) step(*world);
  EXPECT_EQ(achieved(*world), there);
}

}  // namespace
}  // namespace mimo::test
