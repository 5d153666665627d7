// Episodes of the tasks: how they start, what policies earn, how they end.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/format.h"
#include "compat/mujoco.h"
#include "support/block.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using env::World;

engine::ModelPtr model_of(const std::string& scene, const std::string& body = "mitten") {
  static std::map<std::string, engine::ModelPtr> compiled;
  engine::ModelPtr& found = compiled[scene + " " + body];
  if (found == nullptr) found = room_with_infant(scene, body);
  return found;
}

std::unique_ptr<World> world_of(const std::string& scene, const std::map<std::string, double>& parameters = {},
                                const std::string& task = "") {
  env::EnvOptions options = without_renderer();
  options.task = task;
  for (const auto& [name, value] : parameters) options.parameters.set(name, value);
  return std::make_unique<World>(model_of(scene), std::vector<env::AgentOptions>{blind()}, options);
}

std::unique_ptr<World> five_fingered(const std::string& scene) {
  return std::make_unique<World>(model_of(scene, "fingers"), std::vector<env::AgentOptions>{blind()},
                                 without_renderer());
}

tasks::Task& task_of(const World& world) { return *world.agents()[0].task; }

int id_of(const World& world, Kind kind, const std::string& name) {
  return engine::find_or_fail(world.model(), kind, name);
}

Eigen::Vector3d place_of(const World& world, const std::string& body) {
  return Eigen::Map<const Eigen::Vector3d>(world.data().xpos + 3 * id_of(world, Kind::kBody, body));
}

double angle_of(const World& world, const std::string& joint) {
  return world.data().qpos[world.model().jnt_qposadr[id_of(world, Kind::kJoint, joint)]];
}

struct Outcome {
  double reward = 0;
  bool terminated = false, truncated = false;
};

Outcome step(World& world, const std::vector<float>& actions) {
  double reward = 0;
  std::uint8_t terminated = 2, truncated = 2;
  world.step(actions, nullptr, {{&reward, 1}, {&terminated, 1}, {&truncated, 1}});
  double sum = 0;
  for (const tasks::Term& term : task_of(world).terms()) sum += term.value;
  EXPECT_EQ(reward, sum) << "the reward is the sum of its terms";
  return {reward, terminated == 1, truncated == 1};
}

struct Episode {
  double total = 0;
  int steps = 0;
  Outcome last;
};

template <typename Policy>
Episode play(World& world, std::uint64_t seed, Policy&& policy) {
  world.reset(&seed, nullptr);
  Episode episode;
  do {
    episode.last = step(world, policy(world));
    episode.total += episode.last.reward;
    ++episode.steps;
  } while (!episode.last.terminated && !episode.last.truncated && episode.steps < 5000);
  return episode;
}

std::vector<float> nothing(const World& world) { return std::vector<float>(world.action_size()); }

// A hand that is pulled towards a point: forces at the fingers turned into torques of the motors, and some damping.
std::vector<float> pull(const World& world, const Eigen::Vector3d& point) {
  const mjModel& model = world.model();
  std::vector<double> jacobian(static_cast<std::size_t>(3 * model.nv));
  const bool mitten = engine::find(model, Kind::kBody, "right_fingers") >= 0;
  const std::string fingers = mitten ? "right_fingers" : "right_mfknuckle";
  mj_jacBody(&model, &world.data(), jacobian.data(), nullptr, id_of(world, Kind::kBody, fingers));
  const Eigen::Vector3d force = 25 * (point - place_of(world, fingers)).normalized();
  std::vector<float> actions;
  for (const int motor : world.agents()[0].body.actuators) {
    const int dof = model.jnt_dofadr[model.actuator_trnid[2 * motor]];
    double torque = -0.2 * world.data().qvel[dof];
    for (int axis = 0; axis < 3; ++axis)
      torque += jacobian[static_cast<std::size_t>(axis * model.nv + dof)] * force[axis];
    actions.push_back(static_cast<float>(torque / model.actuator_gear[6 * motor]));
  }
  return actions;
}

TEST(Reach, PlacesTheTargetWithinItsRange) {
  const auto world = world_of("reach");
  const Eigen::Vector3d scene(0.3, -0.05, 0.7), low(-0.1, -0.2, -0.1), high(0, 0.1, 0);
  Eigen::Vector3d lowest = scene, highest = scene + low;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    world->reset(&seed, nullptr);
    const Eigen::Vector3d target = place_of(*world, "target");
    EXPECT_TRUE(((target - scene - low).array() >= -1e-9).all() && ((scene + high - target).array() >= -1e-9).all());
    lowest = lowest.cwiseMin(target);
    highest = highest.cwiseMax(target);
    for (int i = 0; i < world->model().nv; ++i) EXPECT_EQ(world->data().qvel[i], 0);
    EXPECT_EQ(world->data().time, 0);
    EXPECT_NE(angle_of(*world, "robot:right_elbow"), 0) << "the infant has moved a little";
  }
  EXPECT_TRUE((((highest - lowest).array() / (high - low).array()) > 0.7).all()) << "all of the range is used";
}

// The angle between where an eye looks and where the target is.
double gaze_error(const World& world, const char* camera) {
  const int id = id_of(world, Kind::kCamera, camera);
  const Eigen::Map<const Eigen::Vector3d> eye(world.data().cam_xpos + 3 * id);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(world.data().cam_xmat + 9 * id);
  const Eigen::Vector3d to = (place_of(world, "target") - eye).normalized();
  return std::acos(std::min(1.0, to.dot(-frame.col(2))));
}

TEST(Reach, LooksAtTheTarget) {
  const auto world = world_of("reach");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    world->reset(&seed, nullptr);
    // The original's formula is exact for a target straight ahead and about 10 degrees off at the side.
    EXPECT_LT(gaze_error(*world, "eye_left"), 0.35);
    EXPECT_LT(gaze_error(*world, "eye_right"), 0.35);
    for (const char* joint : {"robot:left_eye_vertical", "robot:left_eye_torsional", "robot:right_eye_vertical",
                              "robot:right_eye_torsional", "robot:head_tilt_side"}) {
      EXPECT_EQ(angle_of(*world, joint), 0) << joint;
    }
  }
  const auto ahead =
      world_of("reach", {{"reach/target_x_low", 0}, {"reach/target_y_low", 0.05}, {"reach/target_y_high", 0.05}});
  ahead->reset(nullptr, nullptr);
  EXPECT_LT(gaze_error(*ahead, "eye_left"), 0.03);
  EXPECT_LT(gaze_error(*ahead, "eye_right"), 0.03);
}

// After a step the head is where the joints say, seen from everything else as of the last physics step's start.
TEST(Reach, KinematicsIsUpToDateWithTheTurnedHead) {
  const auto world = world_of("reach");
  world->reset(nullptr, nullptr);
  const int target = world->model().jnt_dofadr[world->model().body_jntadr[id_of(*world, Kind::kBody, "target")]];
  world->physics().data().qvel[target + 1] = 0.5;  // the ball flies to the left
  step(*world, nothing(*world));
  const Eigen::Vector3d fingers = place_of(*world, "right_fingers");
  const Eigen::Vector3d camera(world->data().cam_xpos + 3 * id_of(*world, Kind::kCamera, "eye_left"));
  world->physics().update_poses();
  const Eigen::Vector3d now(world->data().cam_xpos + 3 * id_of(*world, Kind::kCamera, "eye_left"));
  EXPECT_LT((now - camera).norm(), MIMO_MUJOCO_4 ? 2e-5 : 1e-5);  // the trunk sways a little more on MuJoCo 4
  EXPECT_GT((place_of(*world, "right_fingers") - fingers).norm(), 0) << "the hand was a step behind";
}

TEST(Reach, RewardsTheDistanceUntilTheTimeLimit) {
  const auto world = world_of("reach");
  const Episode episode = play(*world, 3, nothing);
  EXPECT_EQ(episode.steps, 1000);
  EXPECT_TRUE(episode.last.truncated);
  EXPECT_FALSE(episode.last.terminated);
  const double distance = (place_of(*world, "right_fingers") - place_of(*world, "target")).norm();
  EXPECT_NEAR(episode.total, -1000 * distance, 10) << "the arm hangs";
}

void expect_driven_hand_to_succeed(World& world) {
  int successes = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Episode episode = play(world, seed, [](const World& w) { return pull(w, place_of(w, "target")); });
    if (!episode.last.terminated) continue;
    ++successes;
    EXPECT_EQ(task_of(world).outcome(), tasks::Outcome::kSuccess);
    EXPECT_EQ(episode.last.reward, 100) << "the paper's reward: 100, and no distance";
    EXPECT_GT(episode.total, 0);
  }
  EXPECT_GE(successes, 9);
}

TEST(Reach, AHandDrivenToTheBallSucceeds) { expect_driven_hand_to_succeed(*world_of("reach")); }
TEST(Reach, AHandWithFiveFingersSucceeds) { expect_driven_hand_to_succeed(*five_fingered("reach")); }

// The distance is that of the fingers' middle: of all 16 bones of a hand with five.
TEST(Reach, FiveFingersHaveAMiddle) {
  const auto world = five_fingered("reach");
  const std::uint64_t seed = 3;
  world->reset(&seed, nullptr);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const char* finger : {"ff", "mf", "rf", "lf"}) {
    for (const char* bone : {"knuckle", "middle", "distal"})
      sum += place_of(*world, std::string("right_") + finger + bone);
  }
  for (const char* bone : {"lfmetacarpal", "thbase", "thhub", "thdistal"}) {
    sum += place_of(*world, std::string("right_") + bone);
  }
  task_of(*world).evaluate(world->physics());
  EXPECT_NEAR(task_of(*world).reward(), -(sum / 16 - place_of(*world, "target")).norm(), 1e-12);
}

TEST(Reach, OriginalRulesWantTheTargetMoved) {
  const auto world = world_of("reach", {{"reach/original_rules", 1}});
  const Episode episode = play(*world, 1, [](const World& w) { return pull(w, place_of(w, "target")); });
  EXPECT_TRUE(episode.last.terminated);
  EXPECT_LT(episode.last.reward, 100) << "the distance is subtracted as well";
  EXPECT_GT(episode.last.reward, 99);
}

// An arm that flails for ten seconds often hits a ball that hangs within its reach, but not always.
TEST(Reach, RandomMovementSometimesFindsTheBall) {
  const auto world = world_of("reach");
  Random random(5);
  const auto policy = [&](const World& w) {
    std::vector<float> actions(w.action_size());
    for (float& action : actions) action = static_cast<float>(random.uniform(-1, 1));
    return actions;
  };
  int found = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Episode episode = play(*world, seed, policy);
    if (episode.last.terminated) {
      ++found;
      EXPECT_EQ(episode.last.reward, 100);
    } else {
      EXPECT_LT(episode.total, -150);
      EXPECT_GT(episode.total, -500);
    }
  }
  EXPECT_GT(found, 0);
  EXPECT_LT(found, 8);
}

TEST(Standup, StartsHoldingTheRail) {
  const auto world = world_of("standup");
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    world->reset(&seed, nullptr);
    EXPECT_NEAR(place_of(*world, "head").z(), 0.385, 0.02);
    EXPECT_NEAR(place_of(*world, "left_fingers").z(), 0.45, 0.02);
    EXPECT_NEAR(place_of(*world, "right_fingers").z(), 0.45, 0.02);
  }
}

TEST(Standup, TimeIsUpAfter500StepsAndEffortCosts) {
  const auto world = world_of("standup");
  const Episode idle = play(*world, 0, nothing);
  EXPECT_EQ(idle.steps, 500);
  EXPECT_TRUE(idle.last.truncated);
  EXPECT_NEAR(idle.total, 500 * 0.19, 20);
  world->reset(nullptr, nullptr);
  step(*world, std::vector<float>(27, -0.5f));  // within the bounds of every motor
  EXPECT_NEAR(task_of(*world).terms()[1].value, -0.01 * 27 * 0.25, 1e-9);
}

TEST(Standup, StretchedLegsAreASuccessThatGoesOn) {
  const auto world = world_of("standup");
  // Knees and hips straight, trunk back; the arms are free to follow.
  const auto stretch = [](const World& w) {
    std::vector<float> actions(w.action_size());
    for (std::size_t i = 0; i < actions.size(); ++i) {
      const std::string name = w.agents()[0].actuation->names()[i];
      if (name.find("knee") != std::string::npos || name.find("hip_flex") != std::string::npos) actions[i] = 1;
    }
    return actions;
  };
  bool success = false;
  const Episode episode = play(*world, 0, [&](const World& w) {
    success = success || task_of(w).outcome() == tasks::Outcome::kSuccess;
    return stretch(w);
  });
  EXPECT_TRUE(success);
  EXPECT_EQ(episode.steps, 500) << "success does not end the episode";
  EXPECT_GT(episode.total, 500 * 0.19) << "standing earns more than squatting";
}

TEST(Selfbody, DrawsEveryTargetButTheMovingArm) {
  const auto world = world_of("selfbody");
  Observation observation(*world);
  std::map<std::string, int> drawn;
  const std::vector<std::string> skin = {"hip",
                                         "lower_body",
                                         "upper_body",
                                         "head",
                                         "right_fingers",
                                         "left_upper_arm",
                                         "left_lower_arm",
                                         "right_upper_leg",
                                         "right_lower_leg",
                                         "right_foot",
                                         "left_upper_leg",
                                         "left_lower_leg",
                                         "left_foot"};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    world->reset(&seed, observation.data());
    float sum = 0;
    for (const std::string& body : skin) {
      const float value = observation.at("task/target", body);
      sum += value;
      if (value == 1) ++drawn[body];
    }
    EXPECT_EQ(sum, 1);
  }
  EXPECT_EQ(observation["task/target"].size(), skin.size());
  EXPECT_EQ(drawn.size(), skin.size() - 1);
  EXPECT_EQ(drawn.count("right_fingers"), 0u);
}

// The label of the one in a one-hot vector.
std::string target_of(World& world, Observation& observation) {
  world.observe(observation.data());
  const std::vector<float> target = observation["task/target"];
  for (std::size_t i = 0; i < world.layout().size(); ++i) {
    if (world.layout()[i].name != "task/target") continue;
    return world.layout()[i].label(
        static_cast<std::size_t>(std::max_element(target.begin(), target.end()) - target.begin()));
  }
  return "";
}

TEST(Selfbody, SitsStillWithoutTouchingTheTarget) {
  const auto world = world_of("selfbody");
  Observation observation(*world);
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Episode episode = play(*world, seed, nothing);
    EXPECT_EQ(world->frame_skip(), 1);
    EXPECT_TRUE(episode.last.truncated || episode.last.terminated);
    if (!episode.last.terminated) {
      EXPECT_EQ(episode.steps, 500);
      EXPECT_LE(episode.total, 0);
    }
  }
}

void expect_targets_to_be_touched(World& world) {
  Observation observation(world);
  std::set<std::string> touched;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    world.reset(&seed, nullptr);
    const std::string target = target_of(world, observation);
    const int geom = world.model().body_geomadr[id_of(world, Kind::kBody, target)];
    const Episode episode = play(world, seed, [&](const World& w) {
      return pull(w, Eigen::Map<const Eigen::Vector3d>(w.data().geom_xpos + 3 * geom));
    });
    if (!episode.last.terminated) continue;
    touched.insert(target);
    EXPECT_EQ(episode.last.reward, 500);
    EXPECT_EQ(task_of(world).outcome(), tasks::Outcome::kSuccess);
  }
  // The straight way to the other targets is blocked by the body itself.
  EXPECT_GE(touched.size(), 3u) << join(touched, ", ");
}

TEST(Selfbody, AHandDrivenToItsTargetSucceeds) { expect_targets_to_be_touched(*world_of("selfbody")); }
TEST(Selfbody, AHandWithFiveFingersSucceeds) { expect_targets_to_be_touched(*five_fingered("selfbody")); }

// Of the bodies with skin 15 are bones of five fingers, in place of the mitten; targets are the same.
TEST(Selfbody, FiveFingersAreNoTargets) {
  const auto world = five_fingered("selfbody");
  Observation observation(*world);
  std::set<std::string> drawn;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    world->reset(&seed, observation.data());
    drawn.insert(target_of(*world, observation));
  }
  EXPECT_EQ(observation["task/target"].size(), 12u + 15u);
  EXPECT_EQ(drawn.size(), 12u);
}

// A fingertip on something else earns minus the distance to the target, not -1.
TEST(Selfbody, TouchingElsewhereEarnsTheDistance) {
  const auto world = world_of("selfbody", {{"selfbody/ends_on_success", 0}});
  Observation observation(*world);
  bool seen = false;
  for (std::uint64_t seed = 0; seed < 12 && !seen; ++seed) {
    world->reset(&seed, nullptr);
    const std::string target = target_of(*world, observation);
    for (int i = 0; i < 300 && !seen; ++i) {
      const auto body = Eigen::Vector3d(place_of(*world, "upper_body"));
      const Outcome outcome = step(*world, pull(*world, body));
      const double distance = (place_of(*world, "right_fingers") - place_of(*world, target)).norm();
      if (outcome.reward > -1 && outcome.reward < 0) {
        EXPECT_NEAR(outcome.reward, -distance, 1e-12);
        seen = true;
      }
    }
  }
  EXPECT_TRUE(seen);
}

std::vector<std::uint8_t> bytes_of_episode(World& world, std::uint64_t seed) {
  Observation observation(world);
  std::vector<std::uint8_t> all;
  world.reset(&seed, observation.data());
  for (int i = 0; i < 30; ++i) {
    all.insert(all.end(), observation.bytes().begin(), observation.bytes().end());
    std::vector<float> actions(world.action_size(), 0.3f);
    world.step(actions, observation.data(), {});
  }
  return all;
}

class SameSeed : public ::testing::TestWithParam<const char*> {};

TEST_P(SameSeed, SameBytes) {
  const auto one = world_of(GetParam());
  const auto two = world_of(GetParam());
  bytes_of_episode(*two, 9);  // what was before does not count
  const auto bytes = bytes_of_episode(*one, 7);
  EXPECT_EQ(bytes, bytes_of_episode(*two, 7));
  EXPECT_NE(bytes, bytes_of_episode(*one, 8));
}

INSTANTIATE_TEST_SUITE_P(Tasks, SameSeed,
                         ::testing::Values("reach", "standup", "selfbody", "rollover", "babybench-crib",
                                           "babybench-cubes"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Parameters, ChangeTheTask) {
  const auto world = world_of("reach", {{"reach/episode_steps", 3}, {"reach/distance_weight", 2}});
  const Episode episode = play(*world, 0, nothing);
  EXPECT_EQ(episode.steps, 3);
  const auto usual = world_of("reach");
  EXPECT_DOUBLE_EQ(
      episode.total, 2 * [&] {
        double sum = 0;
        usual->reset(std::vector<std::uint64_t>{0}.data(), nullptr);
        for (int i = 0; i < 3; ++i) sum += step(*usual, nothing(*usual)).reward;
        return sum;
      }());
}

TEST(Parameters, AreCheckedForTheirRange) {
  tasks::Settings settings;
  expect_error(Status::kNotFound, "reach/success_reward", [&] { settings.set("reach/sucess", 1); });
  expect_error(Status::kInvalidArgument, "expected 0 to 1", [&] { settings.set("reach/original_rules", 2); });
  expect_error(Status::kInvalidArgument, "nan", [&] { settings.set("reach/success_reward", std::nan("")); });
  for (const tasks::Parameter* parameter : tasks::parameters()) {
    EXPECT_EQ(settings[parameter->name], parameter->standard);
    EXPECT_NO_THROW(settings.set(parameter->name, parameter->standard)) << "a default is in its range";
  }
}

TEST(Tasks, AreChosenByName) {
  EXPECT_EQ(world_of("reach")->task_name(), "reach");
  EXPECT_EQ(world_of("benchmark")->task_name(), "none");
  const auto none = world_of("reach", {}, "none");
  const Episode start = [&] {
    none->reset(nullptr, nullptr);
    return Episode{0, 0, step(*none, nothing(*none))};
  }();
  EXPECT_EQ(start.last.reward, 0);
  EXPECT_LT((place_of(*none, "target") - Eigen::Vector3d(0.3, -0.05, 0.7)).norm(), 1e-12) << "nothing is random";
  expect_error(Status::kNotFound, "there are: none, reach, standup, selfbody", [] { world_of("reach", {}, "rech"); });
  expect_error(Status::kNotFound, "target", [] { world_of("benchmark", {}, "reach"); });
}

}  // namespace
}  // namespace mimo::test
