// Infants that speak and hear each other, and things that slide.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>

#include "base/fail.h"
#include "env/attached.h"
#include "mimo/experimental/hearing.h"
#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

constexpr double kRate = 16000;

env::AgentOptions speaker(const std::string& name = "") {
  env::AgentOptions options = blind();
  options.name = name;
  options.touch.wanted = 0;
  options.hearing.wanted = MIMO_HEARING_EARS;
  options.voice = true;
  return options;
}

// Two infants in free air, one `distance` m ahead of the other, which looks along x.
engine::ModelPtr two_infants(double distance) {
  scene::Scene scene(from_text("<mujoco><include file='mimo/parts/options.xml'/><worldbody/></mujoco>"));
  const document::Pose here{{0, 0, 1}, {1, 0, 0, 0}}, there{{distance, 0, 1}, {0, 0, 0, 1}};
  scene.add_body("mitten", "anna/", &here);
  scene.add_body("mitten", "bo/", &there);
  return compile(scene);
}

env::EnvOptions weightless(int frame_skip) {
  env::EnvOptions options = without_renderer();
  options.frame_skip = frame_skip;
  options.physics.gravity = false;
  return options;
}

constexpr double kDistance = 2;

std::unique_ptr<env::World> babbling(int frame_skip = 1, bool normalize = false) {
  std::vector<env::AgentOptions> agents = {speaker("anna"), speaker("bo")};
  for (env::AgentOptions& agent : agents) agent.actuation.normalize = normalize;
  auto world = std::make_unique<env::World>(two_infants(kDistance), agents, weightless(frame_skip));
  world->reset(nullptr, nullptr);
  return world;
}

// Anna's voice alone.
std::vector<float> says(const env::World& world, float loudness, float pitch = 0) {
  std::vector<float> actions(world.action_size(), 0.0F);
  const std::size_t voice = world.agents()[0].actuation->commands();
  actions[voice] = loudness;
  actions[voice + 1] = pitch;
  for (const env::Agent& agent : world.agents()) {
    const std::size_t end = agent.action_offset + agent.actuation->size();
    actions[end - 2] = actions[end - 1] = 1;
  }
  return actions;
}

std::vector<float> hears(env::World& world, const std::string& ear, const std::vector<float>& actions, double seconds) {
  std::vector<float> heard;
  Observation block(world);
  for (int i = 0; i < std::lround(seconds / world.step_seconds()); ++i) {
    world.step(Span<const float>(actions), block.data(), {});
    const std::vector<float> now = block[ear];
    heard.insert(heard.end(), now.begin(), now.end());
  }
  return heard;
}

std::size_t onset(const std::vector<float>& stream) {
  std::size_t first = 0;
  while (first < stream.size() && std::abs(stream[first]) < 1e-9F) ++first;
  return first;
}

double level(const std::vector<float>& samples) {
  double sum = 0;
  for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
  return 10 * std::log10(sum / static_cast<double>(samples.size()) / 4e-10 + 1e-30);
}

TEST(Voice, ComesAfterTheMotors) {
  const auto world = babbling();
  const actuation::Actuation& bo = *world->agents()[1].actuation;
  const std::size_t first = bo.commands();
  ASSERT_EQ(bo.size(), first + 4);
  EXPECT_EQ(bo.names()[first], "bo/voice:loudness");
  EXPECT_EQ(bo.names()[first + 1], "bo/voice:pitch");
  EXPECT_EQ(bo.names()[first + 2], "bo/voice:opening");
  EXPECT_EQ(bo.names()[first + 3], "bo/voice:front");
  EXPECT_STREQ(bo.units()[first + 1], "octave");
  EXPECT_EQ(bo.low()[first], 0);
  EXPECT_EQ(bo.high()[first + 1], 0.5F);
  EXPECT_EQ(bo.low()[first + 3], 0.7F);
  const auto normal = babbling(1, true);
  EXPECT_EQ(normal->agents()[0].actuation->low()[first], -1);
}

// 82 dB at 1 m is 99 at the own ears; at the other's, two metres away and looked at, it is 6 dB less than at 1 m, as
// far as heads allow, and later.
TEST(Voice, IsHeardByBoth) {
  const auto world = babbling();
  const std::vector<float> cry = says(*world, 1);
  const std::vector<float> own = hears(*world, "anna/hearing/ear_left", cry, 0.5);
  world->reset(nullptr, nullptr);
  const std::vector<float> other = hears(*world, "bo/hearing/ear_left", cry, 0.5);
  const auto late = [](const std::vector<float>& all) { return std::vector<float>(all.begin() + 4000, all.end()); };
  EXPECT_NEAR(level(late(own)), 99, 1);
  EXPECT_NEAR(level(late(other)), 76, 4);
  const double way = static_cast<double>(onset(other)) - static_cast<double>(onset(own));
  EXPECT_NEAR(way / kRate * 343, kDistance - 0.07, 0.15);  // a mouth is a head's radius nearer, ears turn a little away
}

TEST(Voice, IsSilentWithoutACommand) {
  const auto world = babbling();
  EXPECT_EQ(level(hears(*world, "anna/hearing/ear_left", says(*world, 0), 0.2)), level({0, 0}));
  hears(*world, "anna/hearing/ear_left", says(*world, 1), 0.2);
  hears(*world, "anna/hearing/ear_left", says(*world, 0), 1);
  EXPECT_EQ(level(hears(*world, "bo/hearing/ear_left", says(*world, 0), 0.1)), level({0, 0}));
  hears(*world, "anna/hearing/ear_left", says(*world, 1), 0.1);
  world->reset(nullptr, nullptr);
  EXPECT_EQ(level(hears(*world, "anna/hearing/ear_left", {}, 0.1)), level({0, 0}));
}

TEST(Voice, IsTheSameForAnyFrameSkip) {
  const auto one = babbling(1);
  const std::vector<float> expected = hears(*one, "bo/hearing/ear_right", says(*one, 0.7F, 0.2F), 0.3);
  EXPECT_GT(level(expected), 50);
  for (const int skip : {2, 5}) {
    const auto other = babbling(skip);
    EXPECT_EQ(expected, hears(*other, "bo/hearing/ear_right", says(*other, 0.7F, 0.2F), 0.3)) << skip;
  }
}

// In the middle of a word, with what it was told: no actions leave it speaking.
TEST(Voice, ContinuesFromASavedState) {
  const auto one = babbling(2), other = babbling(2);
  hears(*one, "bo/hearing/ear_left", says(*one, 0.8F, -0.3F), 0.1);
  std::vector<std::uint8_t> state(one->state_bytes());
  one->save(Span<std::uint8_t>(state));
  other->load(Span<const std::uint8_t>(state));
  const std::vector<float> goes_on = hears(*one, "bo/hearing/ear_left", {}, 0.2);
  EXPECT_GT(level(goes_on), 50);
  EXPECT_EQ(goes_on, hears(*other, "bo/hearing/ear_left", {}, 0.2));
}

TEST(Voice, WorksWithMusclesAndWithoutHearing) {
  env::AgentOptions options = speaker();
  options.actuation.mode = actuation::Mode::kMuscle;
  const engine::ModelPtr model = held_infant({1, 0, 0, 0});
  env::World world(model, {options}, weightless(1));
  world.reset(nullptr, nullptr);
  std::vector<float> cry = says(world, 1);
  EXPECT_GT(level(hears(world, "hearing/ear_left", cry, 0.2)), 80);
  options.hearing = {};
  env::World deaf(model, {options}, weightless(1));
  deaf.reset(nullptr, nullptr);
  deaf.step(Span<const float>(cry), nullptr, {});
  EXPECT_EQ(deaf.action_size(), world.action_size());
}

TEST(Voice, IsRefusedForAttachedSenses) {
  EXPECT_THROW(env::Attached({held_infant({1, 0, 0, 0}), {speaker()}, weightless(1), {}}, 0), Error);
}

// A wooden block on a wooden plate, given a push or none.
std::vector<float> sliding_block(double speed, int frame_skip, const char* material = "hardwood") {
  const engine::ModelPtr model = compile(scene::Scene(from_text(R"(
<mujoco>
  <option timestep="0.005"/>
  <worldbody>
    <body name="listener" pos="0 0 1"><geom type="sphere" size="0.0735" contype="0" conaffinity="0"/></body>
    <body name="table" pos="0 0.5 0"><geom type="plane" size="2 2 .1" friction="0.2"/></body>
    <body name="block" pos="0 0.5 0.0199"><freejoint/><geom type="box" size=".02 .02 .02" mass=".05" friction="0.2"/></body>
  </worldbody>
</mujoco>)")));
  env::AgentOptions options = blind();
  options.root = "listener";
  options.vestibular.wanted = 0;
  options.proprioception.wanted = 0;
  options.touch.wanted = 0;
  options.hearing.wanted = MIMO_HEARING_EARS;
  env::EnvOptions world_options = without_renderer();
  world_options.frame_skip = frame_skip;
  world_options.things = {{"block", std::nullopt, material}, {"table", std::nullopt, material}};
  env::World world(model, {options}, world_options);
  world.reset(nullptr, nullptr);
  std::vector<float> nothing = hears(world, "hearing/ear_left", {}, 1);  // it settles
  world.physics().data().qvel[0] = speed;
  return hears(world, "hearing/ear_left", {}, 2);
}

TEST(Scraping, IsHeardUntilItRests) {
  const std::vector<float> pushed = sliding_block(1, 1), still = sliding_block(0, 1);
  EXPECT_EQ(level(still), level({0, 0}));
  EXPECT_GT(level(std::vector<float>(pushed.begin() + 800, pushed.begin() + 4000)), 20);  // it slides for half a second
  EXPECT_EQ(level(std::vector<float>(pushed.begin() + 16000, pushed.end())), level({0, 0}));
  EXPECT_EQ(level(sliding_block(1, 1, "foam")), level({0, 0}));
  EXPECT_EQ(pushed, sliding_block(1, 2));
  EXPECT_EQ(pushed, sliding_block(1, 5));
}

}  // namespace
}  // namespace mimo::test
