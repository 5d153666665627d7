// Limited senses in a world: weaker, noisy, late, blurred.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/block.h"
#include "support/scenes.h"

namespace mimo::test {
namespace {

using Values = std::vector<float>;
constexpr const char* kVelocity = "proprioception/velocity";
constexpr std::uint64_t kSeed = 5;

observation::Limits gain(double factor) { return {factor, 0, 0, 0}; }
observation::Limits noise(double deviation) { return {1, deviation, 0, 0}; }
// Of steps, which are 10 ms long.
observation::Limits delay(int steps) { return {1, 0, 0, 0.01 * steps}; }

env::AgentOptions limited(const std::vector<observation::PathLimits>& limits) {
  env::AgentOptions options = blind();
  options.touch.everywhere = 0.1;
  options.limits = limits;
  return options;
}

std::unique_ptr<env::World> world_with(const std::vector<observation::PathLimits>& limits) {
  return benchmark_world(limited(limits));
}

// A field at reset and after each of some steps of an episode.
std::vector<Values> episode(env::World& world, const std::string& field, int steps, std::uint64_t seed = kSeed) {
  Observation block(world);
  world.reset(&seed, block.data());
  std::vector<Values> values = {block[field]};
  for (int step = 0; step < steps; ++step) {
    world.step(Span<const float>(some_actions(world, step)), block.data(), {});
    values.push_back(block[field]);
  }
  return values;
}

TEST(Limits, WithoutAnyNothingChanges) {
  const auto perfect = world_with({});
  const auto limited = world_with({{"touch", gain(1)}});
  EXPECT_EQ(episode(*perfect, kVelocity, 10), episode(*limited, kVelocity, 10));
  EXPECT_EQ(perfect->state_bytes(), limited->state_bytes());
}

TEST(Limits, GainIsAFactor) {
  const auto perfect = world_with({});
  const auto weak = world_with({{"proprioception", gain(0.25)}, {kVelocity, gain(0.5)}});
  const auto all = episode(*perfect, kVelocity, 5), half = episode(*weak, kVelocity, 5);
  for (std::size_t step = 0; step < all.size(); ++step) {
    for (std::size_t i = 0; i < all[step].size(); ++i) EXPECT_EQ(half[step][i], all[step][i] / 2);
  }
  EXPECT_FLOAT_EQ(episode(*weak, "proprioception/position", 3)[3][20],
                  episode(*perfect, "proprioception/position", 3)[3][20] / 4);
  EXPECT_EQ(episode(*weak, "vestibular/acceleration", 3), episode(*perfect, "vestibular/acceleration", 3));
}

// Mean, deviation and independence of 200 steps of 47 joints: 9400 numbers, so the mean is known to 0.001 and the
// deviation to 0.0007; four times that is allowed.
TEST(Limits, NoiseIsGaussian) {
  const double deviation = 0.1;
  const auto perfect = world_with({});
  const auto noisy = world_with({{kVelocity, noise(deviation)}});
  const auto exact = episode(*perfect, kVelocity, 200), with = episode(*noisy, kVelocity, 200);
  std::vector<double> errors;
  for (std::size_t step = 0; step < exact.size(); ++step) {
    for (std::size_t i = 0; i < exact[step].size(); ++i) {
      errors.push_back(static_cast<double>(with[step][i]) - static_cast<double>(exact[step][i]));
    }
  }
  const auto count = static_cast<double>(errors.size());
  const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / count;
  double square = 0, next = 0, inside = 0;
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
    square += errors[i] * errors[i];
    next += errors[i] * errors[i + 1];
    inside += std::abs(errors[i]) < deviation ? 1 : 0;
  }
  EXPECT_NEAR(mean, 0, 0.004);
  EXPECT_NEAR(std::sqrt(square / count), deviation, 0.003);
  EXPECT_NEAR(next / square, 0, 0.04);
  EXPECT_NEAR(inside / count, 0.6827, 0.02);  // of a Gaussian, within one deviation
}

TEST(Limits, NoiseFollowsFromTheSeed) {
  const auto one = world_with({{"proprioception", noise(0.1)}});
  const auto other = world_with({{"proprioception", noise(0.1)}});
  const auto first = episode(*one, kVelocity, 5);
  EXPECT_EQ(first, episode(*other, kVelocity, 5));
  EXPECT_EQ(first, episode(*one, kVelocity, 5));
  EXPECT_NE(first[3], episode(*one, kVelocity, 5, kSeed + 1)[3]);
}

// Looking neither moves the world nor uses up its random numbers: the same look gives the same, then and later.
TEST(Limits, LookingChangesNothing) {
  const auto world = world_with({{"proprioception", noise(0.1)}, {"touch", delay(3)}});
  const auto undisturbed = episode(*world, kVelocity, 8);
  Observation block(*world), look(*world);
  world->reset(&kSeed, block.data());
  for (int step = 0; step < 8; ++step) {
    world->observe(look.data());
    const auto before = look.bytes();
    world->observe(look.data());
    EXPECT_EQ(before, look.bytes());
    world->step(Span<const float>(some_actions(*world, step)), block.data(), {});
    EXPECT_EQ(block[kVelocity], undisturbed[static_cast<std::size_t>(step) + 1]);
  }
}

TEST(Limits, DelayIsExact) {
  constexpr std::size_t kDelay = 7;
  const auto perfect = world_with({});
  const auto late = world_with({{"touch", delay(kDelay)}, {"proprioception", delay(kDelay)}});
  for (const char* field : {kVelocity, "touch/force"}) {
    const auto now = episode(*perfect, field, 120), then = episode(*late, field, 120);
    for (std::size_t step = 0; step < now.size(); ++step) {
      EXPECT_EQ(then[step], now[step < kDelay ? 0 : step - kDelay]) << field << " " << step;
    }
  }
}

// Also where nobody looks at every step.
TEST(Limits, DelayGoesOnWithoutABlock) {
  const auto late = world_with({{kVelocity, delay(4)}});
  const auto all = episode(*late, kVelocity, 20);
  Observation block(*late);
  late->reset(&kSeed, nullptr);
  for (int step = 0; step < 20; ++step) {
    late->step(Span<const float>(some_actions(*late, step)), step == 19 ? block.data() : nullptr, {});
  }
  EXPECT_EQ(block[kVelocity], all[20]);
}

TEST(Limits, NothingOfTheLastEpisodeIsSensed) {
  const auto late = world_with({{kVelocity, delay(5)}});
  const auto first = episode(*late, kVelocity, 10);
  const auto second = episode(*late, kVelocity, 10);
  EXPECT_EQ(first, second);
  for (std::size_t step = 0; step <= 5; ++step) EXPECT_EQ(second[step], second[0]);
  EXPECT_NE(second[6], second[0]);
}

TEST(Limits, ArePartOfTheState) {
  const std::vector<observation::PathLimits> limits = {{"proprioception", {0.9, 0.05, 0, 0.04}}, {"touch", delay(2)}};
  const auto one = world_with(limits), other = world_with(limits);
  episode(*one, kVelocity, 12);
  std::vector<std::uint8_t> state(one->state_bytes());
  one->save(Span<std::uint8_t>(state));
  episode(*other, kVelocity, 3, kSeed + 9);
  other->load(Span<const std::uint8_t>(state));
  Observation a(*one), b(*other);
  one->observe(a.data());
  other->observe(b.data());
  EXPECT_EQ(a[kVelocity], b[kVelocity]);
  for (int step = 12; step < 24; ++step) {
    one->step(Span<const float>(some_actions(*one, step)), a.data(), {});
    other->step(Span<const float>(some_actions(*other, step)), b.data(), {});
    EXPECT_EQ(a.bytes(), b.bytes()) << step;
  }
}

// The field begins at 0, where most joints are: half of what noise makes of them is cut.
TEST(Limits, StayWithinTheFieldsBounds) {
  const auto noisy = world_with({{"proprioception/limit", noise(5)}});
  double count = 0, cut = 0;
  for (const Values& values : episode(*noisy, "proprioception/limit", 5)) {
    for (const float value : values) {
      EXPECT_GE(value, 0);
      ++count;
      if (value == 0) ++cut;
    }
  }
  EXPECT_NEAR(cut / count, 0.5, 5 * 0.5 / std::sqrt(count));  // five standard deviations of the share
}

TEST(Limits, PathsThatLeadNowhereAreRefused) {
  try {
    world_with({{"taste", gain(0)}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kNotFound);
    EXPECT_NE(error.message().find("no field \"taste\" and none below; there are: proprioception/position"),
              std::string::npos);
  }
  EXPECT_THROW(world_with({{"touch", {1, 0, 2, 0}}}), Error);  // blur is for pictures
}

// The eyes: half the brightness, blurred, and depth as it was.
TEST(Limits, ConcernPicturesInColour) {
  env::AgentOptions options = blind();
  options.touch.wanted = 0;
  options.vision.wanted = MIMO_VISION_RGB | MIMO_VISION_DEPTH;
  options.vision.width = options.vision.height = 32;
  env::EnvOptions rays;
  rays.renderer = env::RendererChoice::kRay;
  const auto perfect = benchmark_world(options, rays);
  options.limits = {{"vision", {0.5, 0, 0, 0}}, {"vision/eye_right", {1, 0, 0.2, 0}}};
  const auto limited = benchmark_world(options, rays);
  Observation all(*perfect), weak(*limited);
  perfect->reset(&kSeed, all.data());
  limited->reset(&kSeed, weak.data());
  const auto& layout = perfect->layout();
  int darker = 0, softer = 0;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    const observation::Field& field = layout[i];
    for (std::size_t at = field.offset; at < field.offset + field.bytes(); ++at) {
      const int before = all.bytes()[at], after = weak.bytes()[at];
      if (field.name == "vision/eye_left") {
        EXPECT_EQ(after, std::lround(before / 2.0));
        darker += after < before ? 1 : 0;
      } else if (field.name == "vision/eye_right") {
        softer += after != before ? 1 : 0;
      } else {
        EXPECT_EQ(after, before) << field.name;
      }
    }
  }
  EXPECT_GT(darker, 1000);
  EXPECT_GT(softer, 500);  // not the even sky
}

}  // namespace
}  // namespace mimo::test
