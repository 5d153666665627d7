// Catching: how episodes start, what a hand that closes by a script earns, how they end.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/block.h"
#include "support/physical.h"
#include "support/scenes.h"
#include "support/tiny.h"

namespace mimo::test {
namespace {

using engine::Kind;
using env::World;

engine::ModelPtr catching_model() {
  static const engine::ModelPtr model = room_with_infant("catch", "fingers");
  return model;
}

std::unique_ptr<World> catching(const std::map<std::string, double>& parameters = {},
                                actuation::Mode mode = actuation::Mode::kMuscle) {
  env::AgentOptions agent = blind();
  agent.actuation.mode = mode;
  env::EnvOptions options = without_renderer();
  for (const auto& [name, value] : parameters) options.parameters.set("catch/" + name, value);
  return std::make_unique<World>(catching_model(), std::vector<env::AgentOptions>{agent}, options);
}

int id_of(const World& world, Kind kind, const std::string& name) {
  return engine::find_or_fail(world.model(), kind, name);
}

Eigen::Vector3d place_of(const World& world, const std::string& body) {
  return Eigen::Map<const Eigen::Vector3d>(world.data().xpos + 3 * id_of(world, Kind::kBody, body));
}

const tasks::Task& task_of(const World& world) { return *world.agents()[0].task; }

double term(const World& world, const std::string& name) {
  for (const tasks::Term& term : task_of(world).terms()) {
    if (name == term.name) return term.value;
  }
  ADD_FAILURE() << "no term " << name;
  return 0;
}

bool has(const std::string& name, const std::string& part) { return name.find(part) != std::string::npos; }

// Where a motor's joint is to be: the palm turned up, fingers a little bent; bent as far as they go when the ball is
// there.
double wanted(const std::string& motor, bool close) {
  if (has(motor, "wrist_rotation")) return -1.5;
  if (has(motor, "wrist") || has(motor, "side")) return 0;
  if (has(motor, "meta")) return close ? 0.6 : 0.3;
  return close ? 1.4 : 0.35;
}

// How hard each motor's joint is to be pulled to where it is to be: the nearer, the less.
std::vector<double> pulls(const World& world) {
  const mjModel& model = world.model();
  const bool close = (place_of(world, "target") - place_of(world, "right_hand")).norm() < 0.06;
  std::vector<double> result;
  for (const int motor : world.agents()[0].body.actuators) {
    const int joint = model.actuator_trnid[2 * motor];
    const double angle = world.data().qpos[model.jnt_qposadr[joint]],
                 speed = world.data().qvel[model.jnt_dofadr[joint]];
    result.push_back(2 * (wanted(engine::name(model, Kind::kActuator, motor), close) - angle) - 0.05 * speed);
  }
  return result;
}

// A hand that closes: of muscles each side pulls a little always.
std::vector<float> closing(const World& world) {
  const std::vector<double> pull = pulls(world);
  std::vector<float> action;
  const auto tell = [&](double value, double low) {
    action.push_back(static_cast<float>(std::clamp(value, low, 1.0)));
  };
  if (world.action_size() == pull.size()) {
    for (const double share : pull) tell(share, -1);
  } else {
    for (const double share : pull) tell(0.1 - share, 0);
    for (const double share : pull) tell(0.1 + share, 0);
  }
  return action;
}

struct Episode {
  int steps = 0;
  int contacts = 0;  // in a row, up to the end
  double total = 0;
  bool terminated = false, truncated = false;
};

template <typename Policy>
Episode play(World& world, std::uint64_t seed, Policy&& policy) {
  world.reset(&seed, nullptr);
  Episode episode;
  while (!episode.terminated && !episode.truncated) {
    double reward = 0;
    std::uint8_t terminated = 2, truncated = 2;
    world.step(policy(world), nullptr, {{&reward, 1}, {&terminated, 1}, {&truncated, 1}});
    ++episode.steps;
    episode.contacts = term(world, "contact") > 0 ? episode.contacts + 1 : 0;
    episode.total += reward;
    episode.terminated = terminated == 1;
    episode.truncated = truncated == 1;
  }
  return episode;
}

int ball_of(const World& world) { return id_of(world, Kind::kBody, "target"); }
double radius_of(const World& world) { return world.model().geom_size[3 * world.model().body_geomadr[ball_of(world)]]; }
double mass_of(const World& world) { return world.model().body_mass[ball_of(world)]; }

TEST(Catch, ActsWithWristAndFingers) {
  const auto world = catching();
  EXPECT_EQ(world->task_name(), "catch");
  EXPECT_EQ(world->action_size(), 40u) << "two muscles for each of 20 motors; the thumb is held";
  for (const std::string& name : world->agents()[0].actuation->names()) {
    EXPECT_TRUE(has(name, "act:right_") && !has(name, "thumb")) << name;
  }
}

// A closing hand catches a ball and holds it, be it moved by muscles or by motors.
void expect_to_catch(World& world) {
  int caught = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Episode episode = play(world, seed, closing);
    EXPECT_TRUE(episode.terminated);
    EXPECT_NE(task_of(world).outcome(), tasks::Outcome::kNone);
    if (task_of(world).outcome() != tasks::Outcome::kSuccess) continue;
    ++caught;
    EXPECT_EQ(episode.contacts, 100) << "steps in a row: held for a second, and not for longer";
    EXPECT_GT(episode.total, 150) << "100 for success, 1 for each step with the ball, less the effort";
    EXPECT_LT((place_of(world, "target") - place_of(world, "right_hand")).norm(), 0.06);
  }
  EXPECT_GE(caught, 9) << "of 12 balls; the smallest ones slip through";
}

TEST(Catch, AClosingHandCatchesAndHolds) { expect_to_catch(*catching()); }

TEST(Catch, MotorsCatchAsMusclesDo) {
  const auto world = catching({}, actuation::Mode::kTorque);
  EXPECT_EQ(world->action_size(), 20u);
  expect_to_catch(*world);
}

TEST(Catch, DoingNothingLosesTheBall) {
  const auto world = catching();
  const Episode episode = play(*world, 4, [](const World& w) { return std::vector<float>(w.action_size()); });
  EXPECT_TRUE(episode.terminated);
  EXPECT_EQ(task_of(*world).outcome(), tasks::Outcome::kFailure);
  EXPECT_EQ(term(*world, "failure"), -100);
  EXPECT_LT(episode.steps, 60);
  const double drop = place_of(*world, "target").z() - place_of(*world, "right_hand").z();
  EXPECT_LT(drop, -0.1);
}

TEST(Catch, EffortCosts) {
  const auto world = catching();
  world->reset(nullptr, nullptr);
  for (int i = 0; i < 15; ++i) world->step(std::vector<float>(world->action_size(), 1), nullptr, {});
  EXPECT_NEAR(term(*world, "effort"), -40 * 1.0 / 40, 1e-6) << "of 40 muscles at full activation";
}

TEST(Catch, BallsAreDrawnFromTheSeed) {
  const auto world = catching();
  Observation observation(*world);
  std::set<double> radii, masses, heights;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    world->reset(&seed, observation.data());
    const double radius = radius_of(*world), mass = mass_of(*world);
    const Eigen::Vector3d place = place_of(*world, "target") - Eigen::Vector3d(0.24, -0.04, 0.8);
    EXPECT_TRUE(radius >= 0.005 && radius <= 0.025) << radius;
    EXPECT_TRUE(mass >= 0.05 && mass <= 0.5) << mass;
    EXPECT_LE(std::abs(place.x()), 0.01);
    EXPECT_LE(std::abs(place.y()), 0.01);
    EXPECT_LE(std::abs(place.z()), 0.08);
    EXPECT_FLOAT_EQ(observation.at("task/ball_radius", "radius"), static_cast<float>(radius));
    EXPECT_EQ(world->model().opt.gravity[2], -9.81) << "it falls again";
    radii.insert(radius);
    masses.insert(mass);
    heights.insert(place.z());
    world->reset(&seed, nullptr);
    EXPECT_EQ(radius, radius_of(*world));
  }
  EXPECT_EQ(radii.size(), 50u);
  EXPECT_EQ(masses.size(), 50u);
  EXPECT_EQ(heights.size(), 50u);
  EXPECT_LT(*radii.begin(), 0.007);
  EXPECT_GT(*radii.rbegin(), 0.023);
}

TEST(Catch, TheArmIsHeldAndTheHandOpen) {
  const auto world = catching();
  const std::uint64_t seed = 1;
  world->reset(&seed, nullptr);
  const auto angle = [&](const char* joint) {
    return world->data().qpos[world->model().jnt_qposadr[id_of(*world, Kind::kJoint, joint)]];
  };
  EXPECT_NEAR(angle("robot:right_shoulder_horizontal"), 1.7, 0.01);
  EXPECT_NEAR(angle("robot:right_shoulder_ad_ab"), 0.8, 0.01);
  EXPECT_NEAR(angle("robot:right_shoulder_rotation"), -1.6, 0.01);
  EXPECT_NEAR(angle("robot:right_elbow"), -0.4, 0.01);
  EXPECT_NEAR(angle("robot:right_th_adduction"), -0.9, 0.05);
  EXPECT_NEAR(angle("robot:right_mf_knuckle"), 0, 0.05) << "the original's hand was half closed by mistake";
}

TEST(Catch, ParametersFixTheBall) {
  const auto world = catching({{"radius_low", 0.02}, {"radius_high", 0.02}, {"mass_low", 0.1}, {"mass_high", 0.1}});
  world->reset(nullptr, nullptr);
  EXPECT_EQ(radius_of(*world), 0.02);
  EXPECT_EQ(mass_of(*world), 0.1);
}

// As MuJoCo's compiler makes it.
TEST(Ball, EqualsABallCompiledWithThatShape) {
  const auto room = [](const char* size, const char* mass) {
    return compile(scene::Scene(from_text(
        std::string("<mujoco><worldbody><body name='box'><freejoint/><geom type='box' size='1 1 1'/></body><body "
                    "name='ball' pos='3 0 0'><freejoint/><geom type='sphere' size='") +
        size + "' mass='" + mass + "'/></body></worldbody></mujoco>")));
  };
  const engine::ModelPtr shared = room("0.025", "0.5");
  engine::Physics world(shared, {});
  const int ball = engine::find_or_fail(*shared, Kind::kBody, "ball");
  EXPECT_TRUE(engine::is_ball(*shared, ball));
  EXPECT_FALSE(engine::is_ball(*shared, engine::find_or_fail(*shared, Kind::kBody, "box")));
  world.shape_ball(ball, 0.013, 0.08);
  expect_same_physics(*room("0.013", "0.08"), world.model(), {1e-12, 1e-15});
  expect_same_physics(*room("0.025", "0.5"), *shared);
}

TEST(Catch, StateHoldsTheBall) {
  const auto world = catching(), twin = catching();
  const std::uint64_t seed = 4, other = 5;
  world->reset(&seed, nullptr);
  twin->reset(&other, nullptr);
  for (int i = 0; i < 30; ++i) world->step(closing(*world), nullptr, {});
  std::vector<std::uint8_t> state(world->state_bytes());
  world->save(Span<std::uint8_t>(state));
  twin->load(Span<const std::uint8_t>(state));
  EXPECT_EQ(radius_of(*world), radius_of(*twin));
  EXPECT_EQ(mass_of(*world), mass_of(*twin));
  for (int i = 0; i < 20; ++i) {
    world->step(closing(*world), nullptr, {});
    twin->step(closing(*twin), nullptr, {});
    EXPECT_EQ(task_of(*world).reward(), task_of(*twin).reward());
  }
  EXPECT_EQ(copy(world->data().qpos, world->model().nq), copy(twin->data().qpos, twin->model().nq));
}

// What the muscles are told when they are told `action`, over some steps; muscles follow with 10 ms.
std::vector<std::vector<double>> told(World& world, std::uint64_t seed, float action, int steps) {
  Observation observation(world);
  world.reset(&seed, nullptr);
  std::vector<std::vector<double>> values;
  for (int step = 0; step < steps; ++step) {
    world.step(std::vector<float>(world.action_size(), action), observation.data(), {});
    const auto activations = observation["proprioception/activation"];
    values.emplace_back(activations.begin(), activations.end());
  }
  return values;
}

TEST(Catch, JitterMultipliesActions) {
  const auto world = catching({{"jitter", 0.2}, {"ends", 0}}), twin = catching({{"jitter", 0.2}, {"ends", 0}});
  const auto values = told(*world, 3, 0.5F, 200);
  std::set<double> seen;
  int changes = 0;
  for (std::size_t step = 12; step < values.size(); ++step) {
    for (const double value : values[step]) {
      EXPECT_GE(value, 0.4 - 1e-3);
      EXPECT_LE(value, 0.6 + 1e-3);
    }
    seen.insert(values[step].begin(), values[step].end());
    const bool settled = std::abs(values[step][0] - values[step - 1][0]) < 0.2 * 0.5 * 1e-3;
    const bool was = std::abs(values[step - 1][0] - values[step - 2][0]) < 0.2 * 0.5 * 1e-3;
    changes += was && !settled;
  }
  EXPECT_LT(*seen.begin(), 0.42) << "of 40 factors, each a number of its own";
  EXPECT_GT(*seen.rbegin(), 0.58);
  EXPECT_GE(changes, 188 / 50 - 1) << "every 10 to 50 steps";
  EXPECT_LE(changes, 188 / 10 + 1);
  EXPECT_EQ(told(*twin, 3, 0.5F, 200), values) << "from the world's seed";
  EXPECT_NE(told(*twin, 4, 0.5F, 200), values);
  for (const auto& step : told(*world, 3, 1, 60)) {
    EXPECT_LE(*std::max_element(step.begin(), step.end()), 1) << "clipped";
  }
}

TEST(Catch, StateHoldsTheJitter) {
  const auto world = catching({{"jitter", 0.2}, {"ends", 0}}), twin = catching({{"jitter", 0.2}, {"ends", 0}});
  told(*world, 3, 0.5F, 25);
  std::vector<std::uint8_t> state(world->state_bytes());
  world->save(Span<std::uint8_t>(state));
  twin->load(Span<const std::uint8_t>(state));
  for (int i = 0; i < 60; ++i) {
    world->step(closing(*world), nullptr, {});
    twin->step(closing(*twin), nullptr, {});
  }
  EXPECT_EQ(copy(world->data().qpos, world->model().nq), copy(twin->data().qpos, twin->model().nq));
}

}  // namespace
}  // namespace mimo::test
