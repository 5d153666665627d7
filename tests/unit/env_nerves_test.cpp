// Nerves in a world: each part is late by what its own nerve takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "body/body.h"
#include "env/description.h"
#include "growth/maturity.h"
#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

constexpr double kTick = 0.005;
constexpr std::uint64_t kSeed = 3;

env::AgentOptions infant(bool with_nerves, double age = 0) {
  env::AgentOptions options = blind();
  options.touch.everywhere = 0.05;
  options.growth.physiological_age = age;
  options.growth.delays = with_nerves;
  return options;
}

std::unique_ptr<env::World> world_of(const env::AgentOptions& agent, int frame_skip) {
  env::EnvOptions options;
  options.frame_skip = frame_skip;
  return std::make_unique<env::World>(benchmark_model(), std::vector<env::AgentOptions>{agent}, options);
}

using Bytes = std::vector<std::uint8_t>;

// Blocks at the reset and after each step; nobody moves it, it falls.
std::vector<Bytes> episode(env::World& world, int steps) {
  Observation block(world);
  world.reset(&kSeed, block.data());
  std::vector<Bytes> blocks = {block.bytes()};
  for (int i = 0; i < steps; ++i) {
    world.step({}, block.data(), {});
    blocks.push_back(block.bytes());
  }
  return blocks;
}

std::size_t ticks(double seconds) { return static_cast<std::size_t>(std::lround(seconds / kTick)); }

// How late an element has to be, by the formula.
std::size_t expected(const env::World& world, const observation::Field& field, std::size_t element) {
  const growth::Conduction at = growth::conduction_at(0);
  if (field.name.compare(0, 10, "vestibular") == 0) return ticks(at.vestibular);
  const bool touch = !field.receptors.empty();
  const int part = touch ? field.receptors[element / 3].body : field.bodies[element];
  return ticks(body::nerve_length(world.model(), part) / at.speed + at.sensory);
}

// The impulse is that of the whole body falling on the floor: what each element of a perfect infant senses, a newborn's
// nerves bring as much later as they take, to the bit.
TEST(Nerves, DelayEachElementByItsNerve) {
  constexpr int kSteps = 90;
  const auto perfect = world_of(infant(false), 1), late = world_of(infant(true), 1);
  const std::vector<Bytes> now = episode(*perfect, kSteps), then = episode(*late, kSteps);
  std::size_t felt = 0, least = 1000, most = 0;
  for (std::size_t f = 0; f < late->layout().size(); ++f) {
    const observation::Field& field = late->layout()[f];
    for (std::size_t e = 0; e < field.count(); ++e) {
      const std::size_t delay = expected(*late, field, e), at = field.offset + 4 * e;
      least = std::min(least, delay);
      most = std::max(most, delay);
      for (std::size_t step = 0; step < then.size(); ++step) {
        const Bytes& source = now[step < delay ? 0 : step - delay];
        ASSERT_TRUE(std::equal(then[step].begin() + at, then[step].begin() + at + 4, source.begin() + at))
            << field.name << " " << e << " at " << step << ", late by " << delay;
      }
      if (!field.receptors.empty() &&
          !std::equal(now[90].begin() + at, now[90].begin() + at + 4, now[0].begin() + at)) {
        ++felt;
      }
    }
  }
  EXPECT_GT(felt, 10u);  // something was touched
  EXPECT_EQ(least, 1u);  // the vestibular organ's 5 ms
  EXPECT_EQ(most, ticks(0.776 / 24.5 + 0.026));
}

double latest(const env::Description& of, const char* name) {
  double seconds = 0;
  for (std::size_t f = 0; f < of.fields.size(); ++f) {
    if (of.fields[f].name != name) continue;
    std::vector<double> delays(of.fields[f].count());
    of.delays[f].tell(delays);
    seconds = *std::max_element(delays.begin(), delays.end());
  }
  return seconds;
}

// Double pain. Where large fibres conduct as adults' do, at 56 m/s, A-delta fibres do at 13 and C fibres at 0.8 m/s;
// cold comes at 6.3 and warmth at 0.7 m/s (Hensel and Iggo 1971). From the toes at 18 months: the foot's 0.79 m,
// and 1.65 times the 5.5 cm from its middle to theirs.
TEST(Nerves, PainArrivesTwice) {
  env::AgentOptions agent = infant(false);
  agent.touch.wanted |=
      MIMO_TOUCH_SA1 | MIMO_TOUCH_COLD | MIMO_TOUCH_WARM | MIMO_TOUCH_NOCICEPTION_FAST | MIMO_TOUCH_NOCICEPTION_SLOW;
  agent.maturity = env::Maturity{};
  agent.maturity->nerves.speed = 56;
  const auto world = world_of(agent, 1);
  const env::Description told = env::describe(*world);
  double metres = 0;  // of the farthest sensor
  for (const observation::Field& field : told.fields) {
    if (field.name != "touch/sa1") continue;
    for (const observation::Receptor& receptor : field.receptors) {
      metres = std::max(metres, body::nerve_length(world->model(), receptor.body));
    }
  }
  EXPECT_NEAR(metres, 0.79 + 1.65 * 0.055, 0.02);
  const double half = 0.5 * kTick + 1e-9;
  EXPECT_NEAR(latest(told, "touch/sa1"), metres / 56, half);
  EXPECT_NEAR(latest(told, "touch/nociception_fast"), metres / 13, half);
  EXPECT_NEAR(latest(told, "touch/nociception_slow"), metres / 0.8, half);
  EXPECT_NEAR(latest(told, "touch/cold"), metres / 6.3, half);
  EXPECT_NEAR(latest(told, "touch/warm"), metres / 0.7, half);
}

TEST(Nerves, DoNotDependOnFrameSkip) {
  env::AgentOptions agent = infant(true);
  agent.limits = {{"vestibular", {0.5, 0.1, 0, 0.015}}};  // noise is that of the time step
  const auto fine = world_of(agent, 1), coarse = world_of(agent, 2), third = world_of(agent, 3);
  const std::vector<Bytes> one = episode(*fine, 120), two = episode(*coarse, 60), three = episode(*third, 40);
  for (std::size_t step = 0; step < two.size(); ++step) EXPECT_EQ(one[2 * step], two[step]) << step;
  for (std::size_t step = 0; step < three.size(); ++step) EXPECT_EQ(one[3 * step], three[step]) << step;
}

TEST(Nerves, SaveSignalsInTransit) {
  const auto first = world_of(infant(true), 2), second = world_of(infant(true), 2);
  episode(*first, 31);
  Bytes state(first->state_bytes());
  first->save(Span<std::uint8_t>(state));
  second->load(Span<const std::uint8_t>(state));
  Observation one(*first), two(*second);
  for (int step = 0; step < 20; ++step) {
    first->step({}, one.data(), {});
    second->step({}, two.data(), {});
    EXPECT_EQ(one.bytes(), two.bytes()) << step;
  }
}

// A camera of the scene is nobody's eye: an infant without a name, whose fields have no prefix, does not make it one.
TEST(Nerves, DoNotDelayCameras) {
  const auto world_beside = [](bool mature) {
    env::AgentOptions agent = infant(mature);
    agent.growth.eyes = mature;
    env::EnvOptions options;
    options.cameras.resize(1);
    options.cameras[0].camera = "eye_left";
    options.cameras[0].vision.width = options.cameras[0].vision.height = 32;
    return std::make_unique<env::World>(benchmark_model(), std::vector<env::AgentOptions>{agent}, options);
  };
  const auto perfect = world_beside(false), newborn = world_beside(true);
  const observation::Field& camera = perfect->layout()[perfect->layout().size() - 1];
  ASSERT_EQ(camera.name, "vision/eye_left");
  const std::vector<Bytes> plain = episode(*perfect, 3), beside = episode(*newborn, 3);
  for (std::size_t step = 0; step < plain.size(); ++step) {
    const auto first = static_cast<std::ptrdiff_t>(camera.offset);
    const auto last = first + static_cast<std::ptrdiff_t>(camera.bytes());
    EXPECT_TRUE(std::equal(plain[step].begin() + first, plain[step].begin() + last, beside[step].begin() + first))
        << step;
  }
}

env::AgentOptions slow_eyes(double flicker) {
  env::AgentOptions agent = infant(false);
  agent.vision.wanted |= MIMO_VISION_RGB;
  agent.vision.width = agent.vision.height = 24;
  agent.maturity = env::Maturity{};
  agent.maturity->eyes.flicker = flicker;
  return agent;
}

// What slow eyes see follows what fast ones see by 1 - exp(-2 pi f t), in light; whether anybody looks at it or not.
TEST(Nerves, SlowEyesFollowWhatFastOnesSee) {
  constexpr double kFlicker = 4;
  const auto light = [](std::uint8_t level) {
    const double code = level / 255.0;
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
  };
  const auto fast = world_of(slow_eyes(0), 2), slow = world_of(slow_eyes(kFlicker), 2);
  const std::vector<Bytes> sharp = episode(*fast, 40), seen = episode(*slow, 40);
  const observation::Field& eye = fast->layout()[fast->layout().size() - 2];
  ASSERT_EQ(eye.name, "vision/eye_left");
  const double share = 1 - std::exp(-2 * 3.14159265358979 * kFlicker * 2 * kTick);
  double differs = 0;
  for (std::size_t i = eye.offset; i < eye.offset + eye.bytes(); ++i) {
    double expected = light(sharp[0][i]);
    for (std::size_t step = 1; step < sharp.size(); ++step) {
      expected += share * (light(sharp[step][i]) - expected);
      ASSERT_NEAR(light(seen[step][i]), expected, 0.006) << i << " in step " << step;
      differs = std::max(differs, std::abs(light(sharp[step][i]) - expected));
    }
  }
  EXPECT_GT(differs, 0.05);

  const auto unseen = world_of(slow_eyes(kFlicker), 2), looked = world_of(slow_eyes(kFlicker), 2);
  Observation last(*unseen), between(*looked);
  for (const auto& world : {unseen.get(), looked.get()}) world->reset(&kSeed, nullptr);
  for (int step = 1; step <= 40; ++step) {
    unseen->step({}, step == 40 ? last.data() : nullptr, {});
    looked->step({}, between.data(), {});
    looked->observe(between.data());
  }
  EXPECT_EQ(last.bytes(), seen[40]);
  const auto at = static_cast<std::ptrdiff_t>(eye.offset), end = at + static_cast<std::ptrdiff_t>(eye.bytes());
  EXPECT_TRUE(std::equal(last.bytes().begin() + at, last.bytes().begin() + end, between.bytes().begin() + at));
}

TEST(Nerves, WhatSlowEyesSawIsPartOfTheState) {
  const auto first = world_of(slow_eyes(2), 2), second = world_of(slow_eyes(2), 2);
  episode(*first, 31);
  Bytes state(first->state_bytes());
  first->save(Span<std::uint8_t>(state));
  second->load(Span<const std::uint8_t>(state));
  Observation one(*first), two(*second);
  for (int step = 0; step < 10; ++step) {
    first->step({}, one.data(), {});
    second->step({}, two.data(), {});
    EXPECT_EQ(one.bytes(), two.bytes()) << step;
  }
  EXPECT_EQ(episode(*first, 3), episode(*second, 3));  // nothing of the episode before is seen
}

// An action of the first step reaches each motor on its tick, also within a step.
TEST(Nerves, ActionsArriveByThePartThatTheyMove) {
  const auto world = world_of(infant(true), 1);
  const growth::Conduction at = growth::conduction_at(0);
  world->reset(&kSeed, nullptr);
  const std::vector<float> actions(world->action_size(), 0.5F);
  const std::vector<int>& motors = world->agents()[0].body.actuators;
  std::size_t nearest = 1000, farthest = 0;
  for (std::size_t step = 0; step < 14; ++step) {
    world->step(step == 0 ? Span<const float>(actions) : Span<const float>(), nullptr, {});
    for (const int motor : motors) {
      const int part = body::moved_by(world->model(), motor);
      const std::size_t delay = ticks(body::nerve_length(world->model(), part) / at.speed + at.motor);
      EXPECT_EQ(world->data().ctrl[motor] != 0, step >= delay) << motor << " in step " << step;
      nearest = std::min(nearest, delay);
      farthest = std::max(farthest, delay);
    }
  }
  EXPECT_EQ(nearest, ticks(0.074 / 24.5 + 0.022));
  EXPECT_GT(farthest, nearest + 3);
}

}  // namespace
}  // namespace mimo::test
