// The labyrinths in worlds: an infant that is held, and a head on a hinge, whose motion is known in full.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>

#include "env/attached.h"
#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

constexpr double kTurn = 60 * 3.14159265358979323846 / 180;
constexpr double kG = 9.81, kGain = 46.165;  // static, (spikes/s)/g

env::AgentOptions balanced() {
  env::AgentOptions options = blind();
  options.touch.wanted = 0;
  options.vestibular.wanted |= MIMO_VESTIBULAR_CANALS | MIMO_VESTIBULAR_OTOLITHS | MIMO_VESTIBULAR_GRAVITY;
  return options;
}

// A head that nothing brakes, on a hinge along z.
constexpr const char* kHead = R"(
<mujoco>
  <option timestep="0.005"/>
  <worldbody><body name="head"><joint name="yaw" type="hinge" axis="0 0 1"/><geom size="0.07"/></body></worldbody>
</mujoco>)";

engine::ModelPtr head_on_hinge() { return compile(scene::Scene(from_text(kHead))); }

env::AgentOptions on_hinge() {
  env::AgentOptions options = balanced();
  options.root = options.vestibular.at = "head";
  options.proprioception.wanted = 0;
  return options;
}

std::unique_ptr<env::World> turning(int frame_skip) {
  env::EnvOptions options = without_renderer();
  options.frame_skip = frame_skip;
  return std::make_unique<env::World>(head_on_hinge(), std::vector<env::AgentOptions>{on_hinge()}, options);
}

// Of the horizontal canals, left and right, regular, above their 90 Hz.
std::pair<double, double> horizontal(const Observation& block) {
  const std::vector<float> rates = block["vestibular/canals"];
  return {static_cast<double>(rates[2]) - 90, static_cast<double>(rates[8]) - 90};
}

// A yaw of 60 degrees a second: 26.18, 21.98, 9.64, 3.55, 1.30 spikes/s about a canal's own axis after 0.005, 1, 5.7,
// 11.4 and 17.1 s (Fernandez and Goldberg 1971, Schneider et al. 2015), of which the horizontal canals feel 0.948 and
// -0.944 (Della Santina et al. 2005). When it stops, they tell the opposite.
TEST(Labyrinth, AYawThatGoesOnFades) {
  const auto world = turning(1);
  Observation block(*world);
  world->reset(nullptr, block.data());
  EXPECT_NEAR(horizontal(block).first, 0, 1e-5);
  world->physics().data().qvel[0] = kTurn;
  world->step({}, block.data(), {});  // the jerk of the start
  int at = 0;
  const double known[][2] = {{0.005, 26.18}, {1, 21.98}, {5.7, 9.64}, {11.4, 3.55}, {17.1, 1.30}};
  for (const auto& [seconds, rate] : known) {
    for (; at < std::lround(seconds / 0.005); ++at) world->step({}, block.data(), {});
    EXPECT_NEAR(horizontal(block).first, 0.948 * rate, 0.01 * rate) << seconds;
    EXPECT_NEAR(horizontal(block).second, -0.944 * rate, 0.01 * rate) << seconds;
  }
  world->physics().data().qvel[0] = 0;
  world->step({}, block.data(), {});
  world->step({}, block.data(), {});
  EXPECT_NEAR(horizontal(block).first, 0.948 * (1.30 - 26.18), 0.3);
}

// Held still, upright and on either ear: canals rest, and each kind of otolith afferent tells its cosine to what is up
// in the head, which sags by a degree. Of the 16 numbers the left utricle's outward regular one is 2, its saccule's
// upward one 4, those of the right side 10 and 12.
TEST(Labyrinth, ATiltIsToldByTheOtolithsAlone) {
  const double half = std::sqrt(0.5);
  for (const std::array<double, 4>& quat :
       {std::array<double, 4>{1, 0, 0, 0}, {half, half, 0, 0}, {half, -half, 0, 0}}) {
    env::World world(held_infant(quat), {balanced()}, without_renderer());
    Observation block(world);
    world.reset(nullptr, block.data());
    for (int i = 0; i < 6000; ++i) world.step({}, i == 5999 ? block.data() : nullptr, {});
    const std::vector<float> canals = block["vestibular/canals"], otoliths = block["vestibular/otoliths"];
    for (std::size_t i = 0; i < canals.size(); ++i) EXPECT_NEAR(canals[i], i % 2 == 0 ? 90 : 60, 0.01) << i;
    const double* head = world.data().xmat + 9 * world.agents()[0].body.head;
    const Eigen::Vector3d up(head[6], head[7], head[8]);  // in the head
    const Eigen::Vector3d told = kGain * kG / 9.80665 * up;
    EXPECT_NEAR(std::abs(up.y()), quat[1] == 0 ? 0 : 1, 0.01);
    EXPECT_NEAR(otoliths[2], 70 + told.y(), 0.1);
    EXPECT_NEAR(otoliths[10], 70 - told.y(), 0.1);
    EXPECT_NEAR(otoliths[4], 70 + told.z(), 0.1);
    EXPECT_NEAR(otoliths[12], 70 + told.z(), 0.1);
    const std::vector<float> gravity = block["vestibular/gravity"];
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(gravity[static_cast<std::size_t>(axis)], kG * up[axis], 0.01);
  }
}

std::vector<std::uint8_t> turned(int frame_skip, bool looked) {
  const auto world = turning(frame_skip);
  Observation block(*world);
  world->reset(nullptr, block.data());
  world->physics().data().qvel[0] = kTurn;
  for (int i = 0; i < 60; i += frame_skip) {
    const bool last = i + frame_skip == 60;
    world->step({}, looked || last ? block.data() : nullptr, {});
  }
  return block.bytes();
}

TEST(Labyrinth, DependsNeitherOnFrameSkipNorOnLooks) {
  const auto once = turned(1, true);
  EXPECT_EQ(turned(1, false), once);
  EXPECT_EQ(turned(2, true), once);
  EXPECT_EQ(turned(5, false), once);
}

// A state goes on as the world did, to the bit, and an episode starts rested.
TEST(Labyrinth, IsPartOfTheState) {
  const auto world = turning(2), other = turning(2);
  Observation block(*world), again(*other);
  world->reset(nullptr, block.data());
  const std::vector<std::uint8_t> fresh = block.bytes();
  world->physics().data().qvel[0] = kTurn;
  for (int i = 0; i < 50; ++i) world->step({}, nullptr, {});
  std::vector<std::uint8_t> state(world->state_bytes());
  world->save(state);
  EXPECT_EQ(other->load(state).fresh, 0U);
  for (int i = 0; i < 10; ++i) world->step({}, block.data(), {});
  for (int i = 0; i < 10; ++i) other->step({}, again.data(), {});
  EXPECT_EQ(block.bytes(), again.bytes());
  EXPECT_NE(block.bytes(), fresh);
  other->reset(nullptr, again.data());
  EXPECT_EQ(again.bytes(), fresh);
}

// Attached to a host's simulation they tell the same bytes, with a state of their own.
TEST(Labyrinth, AttachedItTellsTheSame) {
  const auto world = turning(1);
  Observation block(*world);
  world->reset(nullptr, block.data());
  env::CompiledWorld compiled;
  compiled.model = head_on_hinge();
  compiled.agents = {on_hinge()};
  compiled.options = without_renderer();
  env::Attached senses(compiled, 0);
  std::vector<std::uint8_t> theirs(senses.layout().bytes());
  engine::Physics host(compiled.model, {});
  host.forward();
  senses.reset(host.data(), nullptr);
  world->physics().data().qvel[0] = host.data().qvel[0] = kTurn;
  for (int i = 0; i < 100; ++i) {
    world->step({}, block.data(), {});
    host.step(1);
    senses.advance(host.data());
  }
  senses.observe(host.data(), theirs.data());
  EXPECT_EQ(theirs, block.bytes());
  std::vector<std::uint8_t> state(senses.state_bytes());
  senses.save(state);
  env::Attached next(compiled, 0);
  EXPECT_EQ(next.load(state).fresh, 0U);
  std::fill(theirs.begin(), theirs.end(), std::uint8_t{0});
  next.observe(host.data(), theirs.data());
  EXPECT_EQ(theirs, block.bytes());
}

}  // namespace
}  // namespace mimo::test
