// What an infant hears of a world: blows of things that fall, and sounds that are played.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/random.h"
#include "env/attached.h"
#include "hearing/ears.h"
#include "mimo/experimental/hearing.h"
#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

constexpr double kRate = 16000, kTick = 0.005;

// A listener with a ball for a head, and a block that falls beside it on a plate: from where its speed is known.
std::string scene_with_block(double height) {
  return R"(
<mujoco>
  <option timestep="0.005"/>
  <worldbody>
    <body name="listener" pos="0 0 1"><geom type="sphere" size="0.0735" contype="0" conaffinity="0"/></body>
    <body name="table" pos="0 1 0"><geom type="plane" size="2 2 .1"/></body>
    <body name="block" pos="0 1 )" +
         std::to_string(height) + R"(">
      <freejoint/><geom type="sphere" size="0.02" mass="0.05"/>
    </body>
  </worldbody>
</mujoco>)";
}

env::AgentOptions listener() {
  env::AgentOptions options = blind();
  options.root = "listener";
  options.vestibular.wanted = 0;
  options.proprioception.wanted = 0;
  options.touch.wanted = 0;
  options.hearing.wanted = MIMO_HEARING_EARS | MIMO_HEARING_BANDS;
  return options;
}

env::EnvOptions of_wood(int frame_skip) {
  env::EnvOptions options = without_renderer();
  options.frame_skip = frame_skip;
  options.things = {{"block", std::nullopt, "hardwood"}, {"table", std::nullopt, "hardwood"}};
  return options;
}

std::unique_ptr<env::World> falling(double height, int frame_skip = 1, const env::EnvOptions* options = nullptr) {
  const engine::ModelPtr model = compile(scene::Scene(from_text(scene_with_block(height))));
  auto world = std::make_unique<env::World>(model, std::vector<env::AgentOptions>{listener()},
                                            options == nullptr ? of_wood(frame_skip) : *options);
  world->reset(nullptr, nullptr);
  return world;
}

using Streams = std::array<std::vector<float>, 2>;

Streams listen(env::World& world, double seconds) {
  Streams heard;
  Observation block(world);
  for (int i = 0; i < std::lround(seconds / world.step_seconds()); ++i) {
    world.step({}, block.data(), {});
    for (std::size_t ear = 0; ear < 2; ++ear) {
      const std::vector<float> now = block[ear == 0 ? "hearing/ear_left" : "hearing/ear_right"];
      heard[ear].insert(heard[ear].end(), now.begin(), now.end());
    }
  }
  return heard;
}

// Where a stream begins to sound, in samples.
std::size_t onset(const std::vector<float>& stream) {
  const auto first = std::find_if(stream.begin(), stream.end(), [](float sample) { return sample != 0; });
  return static_cast<std::size_t>(first - stream.begin());
}

double energy(const std::vector<float>& stream) {
  double sum = 0;
  for (const float sample : stream) sum += static_cast<double>(sample) * sample / kRate;
  return sum;
}

// Semi-implicit steps, as MuJoCo's Euler takes them: the block touches where its path of straight pieces does. The
// stream begins a step before the first one, for it ends where the last step starts. MuJoCo's contact lies in the
// middle of the overlap that it then finds.
struct Touch {
  double time, overlap;
};

Touch touch(double height) {
  double z = height - 0.02, v = 0, t = 0;
  for (;;) {
    v -= 9.81 * kTick;
    if (z + v * kTick <= 0) return {t + z / -v, -(z + v * kTick)};
    z += v * kTick;
    t += kTick;
  }
}

TEST(Hearing, HearsABlockWhenItHits) {
  for (const double height : {0.2, 0.201, 0.202, 0.203, 0.207, 0.2117}) {
    const auto world = falling(height);
    const Streams heard = listen(*world, 0.4);
    const hearing::Head head{0.0735, Eigen::Vector3d(0, 0, 1), hearing::ears_of_frame()};
    const Touch hit = touch(height);
    const hearing::Ways ways = hearing::ways_to(head, Eigen::Vector3d(0, 1, -hit.overlap / 2));
    for (std::size_t ear = 0; ear < 2; ++ear) {
      const double expected = (hit.time + kTick + ways[ear].delay) * kRate;
      EXPECT_NEAR(static_cast<double>(onset(heard[ear])), expected + 0.5, 0.501) << height;
    }
    EXPECT_LT(onset(heard[0]), onset(heard[1]));
    EXPECT_GT(energy(heard[0]), energy(heard[1]));
  }
}

// What falls on a box, which reaches from 1 cm below its middle to 1 cm above.
std::string scene_with_thing(const std::string& thing, const std::string& under, double height) {
  return R"(
<mujoco>
  <option timestep="0.005"/>
  <worldbody>
    <body name="listener" pos="0 0 1"><geom type="sphere" size="0.0735" contype="0" conaffinity="0"/></body>
    <body name="table" pos="0 1 -0.01"><geom )" +
         under + R"(/></body>
    <body name="block" pos="0 1 )" +
         std::to_string(height) + R"("><freejoint/><geom mass="0.05" )" + thing + R"(/></body>
  </worldbody>
</mujoco>)";
}

// Shapes, and how far they reach below their middle: flat, on an edge and on a corner boxes are as punctual as balls.
// What touches lies up to 3.5 cm beside the middle.
TEST(Hearing, HearsThingsOfAllShapesWhenTheyHit) {
  const double half = 0.02;
  struct Shape {
    const char* geom;
    double below;
  };
  const Shape shapes[] = {{R"(type="sphere" size="0.02")", half},
                          {R"(type="box" size="0.02 0.02 0.02")", half},
                          {R"(type="box" size="0.02 0.02 0.02" euler="45 0 0")", half * std::sqrt(2)},
                          {R"(type="box" size="0.02 0.02 0.02" euler="35.26438968 45 0")", half * std::sqrt(3)},
                          {R"(type="cylinder" size="0.02 0.02")", half},
                          {R"(type="capsule" size="0.01 0.01")", half},
                          {R"(type="ellipsoid" size="0.015 0.015 0.02")", half}};
  const hearing::Head head{0.0735, Eigen::Vector3d(0, 0, 1), hearing::ears_of_frame()};
  for (const char* under : {R"(type="box" size="0.3 0.3 0.01")", R"(type="cylinder" size="0.3 0.01")"}) {
    for (const Shape& shape : shapes) {
      for (const double drop : {0.18, 0.181, 0.182, 0.183, 0.187, 0.1917}) {
        const std::string scene = scene_with_thing(shape.geom, under, drop + shape.below);
        env::World world(compile(scene::Scene(from_text(scene))), {listener()}, of_wood(1));
        world.reset(nullptr, nullptr);
        const Streams heard = listen(world, 0.3);
        const double hit = (touch(drop + half).time + kTick) * kRate, beside = 0.035 / 343 * kRate;
        for (std::size_t ear = 0; ear < 2; ++ear) {
          const double expected = hit + hearing::ways_to(head, Eigen::Vector3d(0, 1, 0))[ear].delay * kRate;
          EXPECT_NEAR(static_cast<double>(onset(heard[ear])), expected + 0.5, beside + 0.6)
              << shape.geom << " on " << under << " from " << drop;
        }
      }
    }
  }
}

// Without friction, and held upright: a cube that slides on four corners, a ball on one point. The force that presses
// together is their weight both times, so that they scrape alike.
TEST(Hearing, AFlatCubeScrapesAsLoudAsABall) {
  const auto scrape = [](const std::string& geom) {
    const std::string scene = R"(
<mujoco>
  <option timestep="0.005"/>
  <default><geom friction="0 0 0" condim="1"/></default>
  <worldbody>
    <body name="listener" pos="0 0 1"><geom type="sphere" size="0.0735" contype="0" conaffinity="0"/></body>
    <body name="table" pos="1 0 -0.01"><geom type="box" size="0.3 1 0.01"/></body>
    <body name="block" pos="1 -0.2 0.02">
      <joint name="along" type="slide" axis="0 1 0"/><joint name="up" type="slide" axis="0 0 1"/>
      <geom mass="0.2" )" + geom +
                              R"(/>
    </body>
  </worldbody>
</mujoco>)";
    env::World world(compile(scene::Scene(from_text(scene))), {listener()}, of_wood(1));
    world.reset(nullptr, nullptr);
    listen(world, 0.5);
    world.physics().data().qvel[0] = 0.3;
    const Streams heard = listen(world, 1);
    return std::pair{10 * std::log10(energy(heard[0]) + energy(heard[1])), world.data().ncon};
  };
  const auto [ball, one] = scrape(R"(type="sphere" size="0.02")");
  const auto [cube, four] = scrape(R"(type="box" size="0.02 0.02 0.02")");
  EXPECT_EQ(one, 1);
  EXPECT_GE(four, 4);
  EXPECT_NEAR(cube, ball, 0.5);
}

// Exactly: not even the smallest numbers are left.
TEST(Hearing, DoesNotHearThingsAtRest) {
  const auto world = falling(0.2);
  listen(*world, 5);
  const Streams later = listen(*world, 2);
  EXPECT_EQ(energy(later[0]) + energy(later[1]), 0);
  Observation block(*world);
  world->step({}, block.data(), {});
  for (const float level : block["hearing/bands"]) EXPECT_EQ(level, 0);
}

TEST(Hearing, WoodSoundsAndFoamDoesNot) {
  env::EnvOptions soft = of_wood(1);
  soft.things = {{"block", std::nullopt, "foam"}, {"table", std::nullopt, "carpet"}};
  const Streams wood = listen(*falling(0.2), 0.4), foam = listen(*falling(0.2, 1, &soft), 0.4);
  EXPECT_GT(energy(wood[0]), 0);
  EXPECT_EQ(energy(foam[0]), 0);
}

TEST(Hearing, IsTheSameForAnyFrameSkip) {
  const Streams one = listen(*falling(0.2, 1), 0.5);
  for (const int skip : {2, 5}) {
    const Streams other = listen(*falling(0.2, skip), 0.5);
    EXPECT_EQ(one[0], other[0]) << skip;
    EXPECT_EQ(one[1], other[1]) << skip;
  }
}

std::vector<float> beep(double seconds) {
  std::vector<float> samples;
  for (int i = 0; i < seconds * kRate; ++i) samples.push_back(static_cast<float>(0.1 * std::sin(0.3 * i)));
  return samples;
}

TEST(Hearing, ContinuesFromASavedState) {
  const auto one = falling(0.2, 2), other = falling(0.2, 2);
  one->play("block", beep(0.5), kRate);
  listen(*one, 0.25);  // it rings now, and plays
  std::vector<std::uint8_t> state(one->state_bytes());
  one->save(Span<std::uint8_t>(state));
  other->load(Span<const std::uint8_t>(state));
  const Streams goes_on = listen(*one, 0.5), loaded = listen(*other, 0.5);
  EXPECT_GT(energy(goes_on[0]), 0);
  EXPECT_EQ(goes_on[0], loaded[0]);
  EXPECT_EQ(goes_on[1], loaded[1]);
  one->reset(nullptr, nullptr);
  EXPECT_EQ(onset(listen(*one, 0.1)[0]), 0.1 * kRate);
}

// In blocks or at once, the sound is the same.
TEST(Hearing, BlocksFollowEachOther) {
  const auto whole = falling(0.9), parts = falling(0.9);
  const std::vector<float> sound = beep(0.1);
  whole->play("block", sound, kRate);
  Streams heard;
  for (std::size_t i = 0; i < sound.size(); i += 80) {
    parts->play("block", Span<const float>(sound).part(i, 80), kRate);
    const Streams now = listen(*parts, kTick);
    heard[0].insert(heard[0].end(), now[0].begin(), now[0].end());
  }
  EXPECT_EQ(listen(*whole, 0.1)[0], heard[0]);
}

TEST(Hearing, AttachedSensesHearTheSame) {
  const auto world = falling(0.2);
  const Streams expected = listen(*world, 0.4);
  const env::CompiledWorld compiled{
      compile(scene::Scene(from_text(scene_with_block(0.2)))), {listener()}, of_wood(1), {}};
  env::Attached attached(compiled, 0);
  const auto own = falling(0.2);
  attached.reset(own->data(), nullptr);
  std::vector<std::uint8_t> block(attached.layout().bytes());
  std::vector<float> heard;
  for (int i = 0; i < 80; ++i) {
    own->step({}, nullptr, {});
    attached.advance(own->data());
    attached.observe(own->data(), block.data());
    const auto* left = reinterpret_cast<const float*>(block.data() + attached.layout()[0].offset);
    heard.insert(heard.end(), left, left + 80);
  }
  EXPECT_EQ(expected[0], heard);
}

// Kuhn's formula for low frequencies tells the angle: time = 3 radii / speed of sound x sine. A host of ten lines that
// turns towards what it hears: the time between the ears tells where from.
TEST(Hearing, TurnsTowardsANoise) {
  const char* kTurning = R"(
<mujoco>
  <option timestep="0.005"/>
  <worldbody>
    <body name="listener">
      <joint name="neck" axis="0 0 1"/><geom type="sphere" size="0.0735"/>
    </body>
    <body name="rattle" pos="1.2 1.6 0"><geom type="sphere" size="0.02"/></body>
  </worldbody>
</mujoco>)";
  const engine::ModelPtr model = compile(scene::Scene(from_text(kTurning)));
  env::EnvOptions options = without_renderer();
  options.frame_skip = 2;
  options.physics.gravity = false;
  env::World world(model, {listener()}, options);
  world.reset(nullptr, nullptr);
  Observation block(world);
  Random random(7);
  for (int step = 0; step < 150; ++step) {
    std::vector<float> noise(160);
    for (float& sample : noise) sample = static_cast<float>(0.2 * (random.uniform() - 0.5));
    world.play("rattle", noise, kRate);
    world.step({}, block.data(), {});
    const double time = static_cast<double>(block["hearing/time_difference"][0]);
    world.physics().data().qpos[0] += 0.2 * std::asin(std::clamp(time * 343 / (3 * 0.0735), -1.0, 1.0));
  }
  EXPECT_NEAR(world.data().qpos[0] / kDegree, std::atan2(1.6, 1.2) / kDegree, 8);
}

}  // namespace
}  // namespace mimo::test
