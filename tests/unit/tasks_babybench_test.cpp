// Self-touch and hand regard: what is counted, and how episodes open. Whom a touch is credited to, and along which axis
// a hand is looked at, are rules of the competition BabyBench; tests/golden/babybench has its tables.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/numbers.h"
#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

using engine::Kind;
using env::World;
using Pairs = std::vector<std::pair<int, int>>;

std::unique_ptr<World> world_of(const std::string& scene, const std::string& body = "mitten",
                                const std::map<std::string, double>& parameters = {},
                                const env::AgentOptions& agent = blind()) {
  static std::map<std::string, engine::ModelPtr> models;
  engine::ModelPtr& model = models[scene + " " + body];
  if (model == nullptr) model = room_with_infant(scene, body);
  env::EnvOptions options = without_renderer();
  for (const auto& [name, value] : parameters) options.parameters.set(name, value);
  return std::make_unique<World>(model, std::vector<env::AgentOptions>{agent}, options);
}

tasks::Task& task_of(const World& world) { return *world.agents()[0].task; }

std::vector<double> achieved(const World& world) {
  std::vector<double> numbers(static_cast<std::size_t>(task_of(world).goal_size()));
  task_of(world).achieved(world.data(), numbers.data());
  return numbers;
}

std::vector<double> goal(const World& world) {
  std::vector<double> numbers(static_cast<std::size_t>(task_of(world).goal_size()));
  task_of(world).goal(world.data(), numbers.data());
  return numbers;
}

// ---- Self-touch ----------------------------------------------------------------------------------------------------

// Geoms of the mitten body are 3 to 38 in all scenes.
constexpr int kFirst = 3, kGeoms = 36;

// What pairs of geoms in contact come to, one step after the other: numbers of geoms that the right palm, the left
// palm, the right hand, the left hand have touched.
std::vector<std::vector<int>> touched(const std::vector<Pairs>& steps) {
  const auto world = world_of("babybench-base");
  world->reset(nullptr, nullptr);
  engine::Physics& physics = world->physics();
  std::uint64_t number = 0;
  for (const Pairs& pairs : steps) {
    physics.data().ncon = static_cast<int>(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      physics.data().contact[i].geom1 = pairs[i].first;
      physics.data().contact[i].geom2 = pairs[i].second;
    }
    task_of(*world).consider({++number, 0, {}, {}});
    task_of(*world).evaluate(physics);
  }
  const std::vector<double> steps_of = achieved(*world);
  std::vector<std::vector<int>> found(4);
  for (std::size_t i = 0; i < steps_of.size(); ++i) {
    if (steps_of[i] > 0) found[i / kGeoms].push_back(kFirst + static_cast<int>(i % kGeoms));
  }
  return found;
}

using Found = std::vector<std::vector<int>>;

TEST(Selftouch, CreditsPalmsAsTheCompetitionDoesAndHandsRight) {
  // Geoms: 8 head, 12 right lower arm, 13, 14 right palm, 15, 16 right fingers, 19, 20 left palm, 22 left fingers.
  EXPECT_EQ(touched({{{8, 13}, {14, 0}, {8, 13}}}), (Found{{8}, {}, {8}, {}}));
  EXPECT_EQ(touched({{{19, 8}}}), (Found{{}, {8}, {}, {8}}));
  // Two palms: there for the right one only, whichever is named first.
  EXPECT_EQ(touched({{{13, 19}}}), (Found{{19}, {}, {19}, {13}}));
  EXPECT_EQ(touched({{{19, 13}}}), (Found{{19}, {}, {19}, {13}}));
  // Fingers alone: there for nobody.
  EXPECT_EQ(touched({{{15, 12}, {8, 22}}}), (Found{{}, {}, {12}, {8}}));
  // Fingers against the other palm: there it is that palm that touches.
  EXPECT_EQ(touched({{{15, 19}}}), (Found{{}, {15}, {19}, {15}}));
  // The floor is no part of the body, and what belongs to the hand itself does not count.
  EXPECT_EQ(touched({{{15, 0}, {15, 16}}}), (Found{{}, {}, {}, {}}));
}

TEST(Selftouch, ReportsTheStepOfTheFirstTouch) {
  const auto world = world_of("babybench-base");
  world->reset(nullptr, nullptr);
  engine::Physics& physics = world->physics();
  const auto step = [&](std::uint64_t number, int other) {
    physics.data().ncon = 1;
    physics.data().contact[0].geom1 = 13;
    physics.data().contact[0].geom2 = other;
    task_of(*world).consider({number, 0, {}, {}});
    task_of(*world).evaluate(physics);
  };
  step(4, 8);
  step(5, 8);
  step(9, 12);
  EXPECT_EQ(achieved(*world)[8 - kFirst], 4);
  EXPECT_EQ(achieved(*world)[12 - kFirst], 9);
  world->reset(nullptr, nullptr);
  EXPECT_EQ(achieved(*world), std::vector<double>(4 * kGeoms));
}

TEST(Selftouch, ListsTheTouchableParts) {
  // The competition divides by 34 a hand: all 36 geoms but the two of its palm. Two more are those of the own fingers.
  const auto world = world_of("babybench-base");
  const std::vector<double> all = goal(*world);
  const std::vector<int> expected = {34, 34, 32, 32};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(i * kGeoms);
    EXPECT_EQ(std::accumulate(first, first + kGeoms, 0.0), expected[i]);
  }
  EXPECT_EQ(all[13 - kFirst], 0);
  EXPECT_EQ(all[15 - kFirst], 1);
  EXPECT_EQ(all[2 * kGeoms + 15 - kFirst], 0);
  // Of the body with five fingers there are 74 (geoms 3 to 76).
  EXPECT_EQ(goal(*world_of("babybench-base", "fingers")).size(), 4U * 74U);
}

TEST(Selftouch, RewardsNewTouchesIfAsked) {
  const auto world = world_of("babybench-crib", "mitten", {{"selftouch/touch_reward", 2}});
  double reward = 0, sum = 0;
  world->reset(nullptr, nullptr);
  for (int i = 0; i < 600; ++i) {
    const std::vector<float> actions = some_actions(*world, i / 20);  // long enough for arms to get anywhere
    world->step(Span<const float>(actions), nullptr, {{&reward, 1}, {}, {}});
    sum += reward;
  }
  const std::vector<double> steps = achieved(*world);
  const auto by_hands = std::count_if(steps.begin() + 2 * kGeoms, steps.end(), [](double it) { return it > 0; });
  EXPECT_GT(by_hands, 0);
  EXPECT_EQ(sum, 2 * static_cast<double>(by_hands));
}

// ---- Hand regard ---------------------------------------------------------------------------------------------------

// What a step counts with the right hand in a direction of the right eye's frame; all else is far behind.
std::vector<double> looked(const Eigen::Vector3d& axis, double metres = 0.2) {
  const auto world = world_of("babybench-cubes", "fingers");
  world->reset(nullptr, nullptr);
  engine::Physics& physics = world->physics();
  const auto place = [&](const char* body) {
    return Eigen::Map<Eigen::Vector3d>(physics.data().xpos +
                                       3 * engine::find_or_fail(world->model(), Kind::kBody, body));
  };
  const int eye = engine::find_or_fail(world->model(), Kind::kBody, "right_eye");
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(physics.data().xmat + 9 * eye);
  place("right_hand") = place("right_eye") + metres * (axes * axis.normalized());
  place("left_hand") = place("right_eye");  // a hand in the eye itself is never looked at
  place("left_eye") = place("right_eye") + axes * Eigen::Vector3d(9, 0, -9);
  task_of(*world).consider({1, 0, {}, {}});
  task_of(*world).evaluate(physics);
  EXPECT_EQ(goal(*world), std::vector<double>(8, 1));
  return achieved(*world);
}

TEST(Handregard, MeasuresDownTheFaceAndAlongTheCamera) {
  const std::vector<double> down = {1, 0, 0, 0, 0, 0, 0, 0}, in_view = {0, 0, 0, 0, 1, 0, 0, 0}, nowhere(8);
  EXPECT_EQ(looked({1, 0, 0}), in_view);
  EXPECT_EQ(looked({0, 0, -1}), down);
  EXPECT_EQ(looked({-1, 0, 1}), nowhere);
  for (const double sign : {-1.0, 1.0}) {
    const auto beside = [sign](double degrees) {
      return Eigen::Vector3d(std::cos(degrees * kDegree), sign * std::sin(degrees * kDegree), 0);
    };
    EXPECT_EQ(looked(beside(14.9)), in_view);
    EXPECT_EQ(looked(beside(15.1)), nowhere);
  }
}

// The axis that is right is the one along which pictures are taken.
TEST(Handregard, TheCamerasLookAlongTheAxis) {
  const auto world = world_of("babybench-cubes", "fingers");
  world->reset(nullptr, nullptr);
  for (const std::string side : {"left", "right"}) {
    const int eye = engine::find_or_fail(world->model(), Kind::kBody, side + "_eye");
    const int camera = engine::find_or_fail(world->model(), Kind::kCamera, "eye_" + side);
    for (int i = 0; i < 3; ++i) {  // cameras look along their own -z
      EXPECT_NEAR(world->data().xmat[9 * eye + 3 * i], -world->data().cam_xmat[9 * camera + 3 * i + 2], 1e-9);
    }
  }
}

// ---- Episodes ------------------------------------------------------------------------------------------------------

class Opening : public testing::TestWithParam<const char*> {};

// 100 physics steps without control lead from the stored pose to the start; 10 of random actions follow.
TEST_P(Opening, SettlesAndMovesAtRandom) {
  const std::string task = std::string(GetParam()) == "babybench-cubes" ? "handregard" : "selftouch";
  const auto still = world_of(GetParam(), "mitten", {{task + "/warm_up_steps", 0}});
  const auto by_hand = world_of(GetParam(), "mitten", {{task + "/warm_up_steps", 0}, {task + "/settle_steps", 0}});
  const auto moved = world_of(GetParam());
  still->reset(nullptr, nullptr);
  by_hand->reset(nullptr, nullptr);
  by_hand->step_physics(100);
  const auto nq = static_cast<std::size_t>(still->model().nq);
  const Span<const double> settled(still->data().qpos, nq), expected(by_hand->data().qpos, nq);
  for (std::size_t i = 0; i < nq; ++i) EXPECT_NEAR(settled[i], expected[i], 1e-9) << i;
  EXPECT_EQ(still->data().time, 0);

  const std::uint64_t seed = 3;
  moved->reset(&seed, nullptr);
  const std::vector<double> first(moved->data().qpos, moved->data().qpos + nq);
  const actuation::Actuation& motors = *moved->agents()[0].actuation;
  for (std::size_t i = 0; i < motors.size(); ++i) {
    const double last = moved->data().ctrl[moved->agents()[0].body.actuators[i]];
    EXPECT_GE(last, static_cast<double>(motors.low()[i]));
    EXPECT_LE(last, static_cast<double>(motors.high()[i]));
  }
  moved->reset(nullptr, nullptr);
  EXPECT_NE(first, std::vector<double>(moved->data().qpos, moved->data().qpos + nq));
  moved->reset(&seed, nullptr);
  EXPECT_EQ(first, std::vector<double>(moved->data().qpos, moved->data().qpos + nq));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Opening, testing::Values("babybench-base", "babybench-crib", "babybench-cubes"));

// Random actions are whatever the infant acts with: after ten steps of targets drawn from 0 to 1, activations are
// there.
TEST(Opening, MovesMusclesToo) {
  env::AgentOptions agent = blind();
  agent.actuation.mode = actuation::Mode::kMuscle;
  const auto world = world_of("babybench-crib", "mitten", {}, agent);
  Observation observation(*world);
  world->reset(nullptr, observation.data());
  const std::vector<float> activation = observation["proprioception/activation"];
  EXPECT_GT(*std::min_element(activation.begin(), activation.end()), 0.0f);
  EXPECT_LT(*std::max_element(activation.begin(), activation.end()), 1.0f);
}

}  // namespace
}  // namespace mimo::test
