// What nerves of a skin tell of a probe that is let down on a palm, stays and is lifted; of warm and cold things.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>

#include "env/attached.h"
#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

constexpr double kTick = 0.005, kSpacing = 0.01;
constexpr double kWeight = 0.5 * 9.81;  // N

// A palm that lies still, and a probe above it that only goes up and down.
constexpr const char* kPalm = R"(
<mujoco>
  <option timestep="0.005"/>
  <worldbody>
    <body name="left_hand"><geom type="box" size="0.05 0.05 0.01"/></body>
    <body name="probe" pos="0 0 0.0215">
      <joint name="down" type="slide" axis="0 0 1" damping="20"/><geom type="sphere" size="0.01" mass="0.5"/>
    </body>
  </worldbody>
</mujoco>)";

env::AgentOptions palm() {
  env::AgentOptions options = blind();
  options.root = "left_hand";
  options.vestibular.wanted = 0;
  options.proprioception.wanted = 0;
  options.touch.everywhere = kSpacing;
  options.touch.response = senses::touch::Response::kNearest;
  options.touch.wanted = MIMO_TOUCH_NORMAL_FORCE | senses::kSkinNerves;
  return options;
}

engine::ModelPtr model() {
  static const engine::ModelPtr kModel = compile(scene::Scene(from_text(kPalm)));
  return kModel;
}

env::EnvOptions with_probe(double celsius, const std::string& material, int frame_skip = 1) {
  env::EnvOptions options = without_renderer();
  options.frame_skip = frame_skip;
  options.things = {{"probe", celsius, material}};
  return options;
}

std::unique_ptr<env::World> world_with(const env::EnvOptions& options) {
  return std::make_unique<env::World>(model(), std::vector<env::AgentOptions>{palm()}, options);
}

struct Told {
  float force, sa1, ra, pc, temperature, cold, warm, fast, slow;
};

float most(const std::vector<float>& values) { return *std::max_element(values.begin(), values.end()); }
float least(const std::vector<float>& values) { return *std::min_element(values.begin(), values.end()); }

// Of the sensor that the probe is on: no other feels anything.
Told told(const Observation& block) {
  return {most(block["touch/force"]),
          most(block["touch/sa1"]),
          most(block["touch/ra"]),
          most(block["touch/pc"]),
          least(block["touch/temperature"]),
          most(block["touch/cold"]),
          least(block["touch/warm"]),
          most(block["touch/nociception_fast"]),
          most(block["touch/nociception_slow"])};
}

void step(env::World& world, Observation& block, double seconds) {
  for (int i = 0; i < std::lround(seconds / world.step_seconds()); ++i) world.step({}, block.data(), {});
}

// Skin of this spacing stiffens at 300 N/m x 10 mm = 3 N: 4.905 N press it in by 3 mm 4.905 / 7.905 = 1.86 mm, of which
// TouchSim's SA1 make 48 (1.86 - 0.08) = 85.5 Hz for as long as it is held, and RA and PC nothing at all.
TEST(SkinReceptors, OnlySa1ReportsAHeldPress) {
  const auto world = world_with(with_probe(33, "plastic"));
  Observation block(*world);
  world->reset(nullptr, block.data());
  EXPECT_EQ(told(block).sa1, 0);
  float jolt = 0, moving = 0;
  for (int i = 0; i < 40; ++i) {
    step(*world, block, kTick);
    jolt = std::max(jolt, told(block).pc);
    moving = std::max(moving, told(block).ra);
  }
  EXPECT_GT(jolt, 10);
  EXPECT_GT(moving, 50);
  step(*world, block, 2);
  EXPECT_NEAR(told(block).force, kWeight, 0.01 * kWeight);
  EXPECT_NEAR(told(block).sa1, 85.5, 0.02 * 85.5);
  EXPECT_EQ(told(block).ra, 0);
  EXPECT_EQ(told(block).pc, 0);
  EXPECT_EQ(told(block).fast, 0);  // 10 mm are not sharp
  // Lifted: RA and PC tell it, then all is silent.
  world->physics().data().qfrc_applied[0] = 40;
  step(*world, block, 2 * kTick);
  EXPECT_GT(told(block).ra, 50);
  step(*world, block, 0.5);
  EXPECT_EQ(told(block).sa1, 0);
  EXPECT_EQ(told(block).ra, 0);
  EXPECT_EQ(told(block).pc, 0);
  EXPECT_EQ(most(block["touch/sa2"]), 0);
}

// Seconds since the probe began to touch.
double press(env::World& world, Observation& block, double seconds) {
  world.reset(nullptr, block.data());
  for (int i = 0; told(block).sa1 == 0 && i < 100; ++i) step(world, block, kTick);
  step(world, block, seconds);
  return seconds;
}

// Skin of 33.0 degrees after 10 s on something of 22: copper 27.85, plastic 30.79 (two half-spaces with a contact of
// 350 W/(m^2 K), as Ho and Jones 2006 measured fingers). A metal cup of 10 degrees feels colder than a wooden one.
TEST(SkinReceptors, MetalFeelsColderThanWood) {
  const double copper = [&] {
    const auto world = world_with(with_probe(22, "copper"));
    Observation block(*world);
    press(*world, block, 10);
    return static_cast<double>(told(block).temperature);
  }();
  const auto plastic = world_with(with_probe(22, "plastic"));
  Observation block(*plastic);
  press(*plastic, block, 10);
  EXPECT_NEAR(copper, 27.85, 0.05);
  EXPECT_NEAR(told(block).temperature, 30.79, 0.05);
  float cold[2];
  for (const bool metal : {false, true}) {
    const auto cup = world_with(with_probe(10, metal ? "copper" : "hardwood"));
    press(*cup, block, 0.5);
    cold[metal] = told(block).cold;
  }
  EXPECT_GT(cold[1], 1.5F * cold[0]);
}

// Untouched skin is 33.0 degrees in a room of 24 and stays so; what was cooled comes back with 116.5 s.
TEST(SkinReceptors, SkinComesBackToItsOwnTemperature) {
  const auto world = world_with(with_probe(10, "copper"));
  Observation block(*world);
  press(*world, block, 5);
  EXPECT_NEAR(most(block["touch/temperature"]), 33.0, 0.02);
  world->physics().data().qfrc_applied[0] = 40;
  step(*world, block, 0.5);
  const double start = static_cast<double>(told(block).temperature) - 33.003;
  step(*world, block, 116.5);
  EXPECT_NEAR(told(block).temperature - 33.003, start * std::exp(-1), 0.02 * std::abs(start));
}

// Metal of 70 degrees: slow nociceptors from 43, fast ones from 46.
TEST(SkinReceptors, HeatHurts) {
  const auto world = world_with(with_probe(70, "copper"));
  Observation block(*world);
  press(*world, block, 10);
  const double skin = static_cast<double>(most(block["touch/temperature"]));
  EXPECT_GT(skin, 46);
  EXPECT_NEAR(told(block).slow, std::min(20.0, 2 * (skin - 43)), 1e-3);
  EXPECT_NEAR(told(block).fast, 5 * (skin - 46), 1e-3);
}

// A palm has 58 afferents a square centimetre (Johansson and Vallbo 1979); a sensor has 0.87 spacings squared.
TEST(SkinReceptors, CountTheirAfferents) {
  const auto world = world_with(with_probe(33, "plastic"));
  Observation block(*world);
  world->reset(nullptr, block.data());
  const std::vector<float> units = block["touch/units"];
  EXPECT_NEAR(units[0] + units[1] + units[2] + units[3], 58 * 0.87, 0.1);
}

std::vector<std::uint8_t> pressed(int frame_skip, bool looked) {
  const auto world = world_with(with_probe(15, "steel", frame_skip));
  Observation block(*world);
  world->reset(nullptr, block.data());
  for (int i = 0; i < 20; i += frame_skip) {
    world->step({}, looked || i + frame_skip == 20 ? block.data() : nullptr, {});
  }
  return block.bytes();
}

TEST(SkinReceptors, DependNeitherOnFrameSkipNorOnLooks) {
  const auto once = pressed(1, true);
  EXPECT_EQ(pressed(1, false), once);
  EXPECT_EQ(pressed(2, true), once);
  EXPECT_EQ(pressed(5, false), once);
}

TEST(SkinReceptors, ArePartOfTheState) {
  const auto world = world_with(with_probe(15, "steel")), other = world_with(with_probe(15, "steel"));
  Observation block(*world), again(*other);
  world->reset(nullptr, block.data());
  const std::vector<std::uint8_t> fresh = block.bytes();
  step(*world, block, 0.06);
  std::vector<std::uint8_t> state(world->state_bytes());
  world->save(state);
  EXPECT_EQ(other->load(state).fresh, 0U);
  step(*world, block, 0.05);
  step(*other, again, 0.05);
  EXPECT_EQ(block.bytes(), again.bytes());
  EXPECT_NE(block.bytes(), fresh);
  other->reset(nullptr, again.data());
  EXPECT_EQ(again.bytes(), fresh);
}

// Attached to a host's simulation they tell the same bytes.
TEST(SkinReceptors, ReportTheSameWhenAttached) {
  const auto world = world_with(with_probe(15, "steel"));
  Observation block(*world);
  world->reset(nullptr, block.data());
  env::Attached senses({model(), {palm()}, with_probe(15, "steel"), {}}, 0);
  std::vector<std::uint8_t> theirs(senses.layout().bytes());
  engine::Physics host(model(), {});
  host.forward();
  senses.reset(host.data(), nullptr);
  for (int i = 0; i < 60; ++i) {
    world->step({}, block.data(), {});
    host.step(1);
    senses.advance(host.data());
  }
  senses.observe(host.data(), theirs.data());
  EXPECT_EQ(theirs, block.bytes());
}

TEST(SkinReceptors, RefuseThingsThatAreNotThere) {
  env::EnvOptions options = with_probe(15, "steel");
  options.things[0].body = "cup";
  try {
    world_with(options);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("cup"), std::string::npos);
  }
}

}  // namespace
}  // namespace mimo::test
