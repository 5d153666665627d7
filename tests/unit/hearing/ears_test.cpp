// Two ears: times and levels against the exact sphere, and what moves.
#include "hearing/ears.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/numbers.h"
#include "sound/air.h"
#include "unit/hearing/exact_sphere.h"

namespace mimo::hearing {
namespace {

constexpr double kRate = 16000;
constexpr std::size_t kTick = 80;
constexpr double kRadius = 0.0735;  // of the 18-month-old's head

Head head(double radius = kRadius) { return {radius, Eigen::Vector3d::Zero(), ears_of_frame()}; }

// With ears straight to the sides, as tables of spheres have them.
Head plain_head(double radius = kRadius) {
  Head head{radius, Eigen::Vector3d::Zero(), {}};
  head.ears = {Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitY()};
  return head;
}

Eigen::Vector3d direction(double azimuth) { return {std::cos(azimuth * kDegree), std::sin(azimuth * kDegree), 0}; }

std::vector<float> tone(double frequency, double seconds, double amplitude = 1) {
  std::vector<float> samples;
  for (int i = 0; i < seconds * kRate; ++i) {
    samples.push_back(static_cast<float>(amplitude * std::sin(2 * kPi * frequency * i / kRate)));
  }
  return samples;
}

using Streams = std::array<std::vector<float>, kEars>;

// What is heard of samples that are played at a place that moves.
template <typename Place>
Streams play(const std::vector<float>& samples, Place&& place, const Head& listener = head()) {
  sound::Queue queue(samples.size());
  queue.add(samples, 0);
  Ears ears(kTick, kRate, kTick, 1);
  Streams heard;
  for (std::size_t now = 0; now < samples.size(); now += kTick) {
    Source source{&queue, place(static_cast<double>(now + kTick) / kRate), now == 0};
    ears.advance(listener, Span<const Source>(&source, 1), static_cast<std::int64_t>(now));
    for (std::size_t ear = 0; ear < kEars; ++ear) {
      std::vector<float> block(kTick);
      ears.latest(ear, block);
      heard[ear].insert(heard[ear].end(), block.begin(), block.end());
    }
  }
  return heard;
}

// The complex amplitude of the last half of a stream.
std::complex<double> amplitude(const std::vector<float>& stream, double frequency) {
  std::complex<double> sum = 0;
  double weights = 0;
  const std::size_t first = stream.size() / 2, count = stream.size() - first;
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = 0.5 - 0.5 * std::cos(2 * kPi * static_cast<double>(i) / static_cast<double>(count));
    const double angle = 2 * kPi * frequency * static_cast<double>(first + i) / kRate;
    sum += weight * static_cast<double>(stream[first + i]) * std::complex<double>(std::sin(angle), std::cos(angle));
    weights += weight;
  }
  return 2.0 * sum / weights;
}

struct Difference {
  double time;   // us, positive where left is first
  double level;  // dB, positive where left is louder
};

Difference between(const std::complex<double>& left, const std::complex<double>& right, double frequency) {
  return {std::arg(left / right) / (2 * kPi * frequency) * 1e6, 20 * std::log10(std::abs(left / right))};
}

Difference heard(double frequency, double azimuth, double distance, const Head& listener = head()) {
  const Streams streams = play(
      tone(frequency, 0.2), [&](double) { return Eigen::Vector3d(distance * direction(azimuth)); }, listener);
  return between(amplitude(streams[0], frequency), amplitude(streams[1], frequency), frequency);
}

double angle_to_ear(double azimuth, std::size_t ear, const Head& listener) {
  return std::acos(std::clamp(listener.ears[ear].dot(direction(azimuth)), -1.0, 1.0));
}

Difference exact(double frequency, double azimuth, double distance, const Head& listener = head()) {
  return between(exact_sphere(listener.radius, distance, angle_to_ear(azimuth, 0, listener), frequency),
                 exact_sphere(listener.radius, distance, angle_to_ear(azimuth, 1, listener), frequency), frequency);
}

// Numbers of the exact solution for a far source and ears at 90 degrees, from a table made apart from this file.
TEST(ExactSphere, EqualsThePublishedTable) {
  const auto far = [](double z, double f) {
    return between(exact_sphere(kRadius, 1000, (90 - z) * kDegree, f),
                   exact_sphere(kRadius, 1000, (90 + z) * kDegree, f), f);
  };
  EXPECT_NEAR(far(30, 500).time, 339, 1);
  EXPECT_NEAR(far(60, 250).time, 569, 1);
  EXPECT_NEAR(far(90, 500).time, 649, 1);
  EXPECT_NEAR(far(45, 2000).level, 8.0, 0.1);
  EXPECT_NEAR(far(75, 4000).level, 9.9, 0.1);
}

// Heads of newborns, of 18 and 24 months and of adults, at all azimuths.
const double kRadii[] = {0.0544, kRadius, 0.0759, 0.0875};

TEST(Ears, TimeDifferencesAreThoseOfTheExactSphere) {
  for (const double radius : kRadii) {
    for (double azimuth = -175; azimuth <= 180; azimuth += 5) {
      for (const double frequency : {250.0, 500.0, 1000.0}) {
        EXPECT_NEAR(heard(frequency, azimuth, 2, head(radius)).time, exact(frequency, azimuth, 2, head(radius)).time,
                    10)
            << azimuth << " degrees, " << frequency << " Hz, " << radius;
      }
    }
  }
}

TEST(Ears, LevelDifferencesAreThoseOfTheExactSphere) {
  for (const double radius : kRadii) {
    for (const Head& listener : {head(radius), plain_head(radius)}) {
      for (double azimuth = 0; azimuth <= 180; azimuth += 2.5) {  // the other side is the mirror
        for (const double frequency : {250.0, 500.0, 1000.0, 2000.0, 3000.0, 4000.0}) {
          EXPECT_NEAR(heard(frequency, azimuth, 2, listener).level, exact(frequency, azimuth, 2, listener).level,
                      frequency < 750 ? 0.3 : 2.1)
              << azimuth << " degrees, " << frequency << " Hz, " << radius;
        }
      }
    }
  }
}

// Nearer ones: both ears, all sides.
TEST(Ears, NearSourcesAreAsLoudAsOnTheExactSphere) {
  for (double azimuth = -170; azimuth <= 180; azimuth += 10) {
    for (const double distance : {0.15, 0.25, 0.3, 0.5, 1.0}) {
      for (const double frequency : {250.0, 500.0}) {
        EXPECT_NEAR(heard(frequency, azimuth, distance).level, exact(frequency, azimuth, distance).level, 0.6)
            << azimuth << " degrees, " << distance << " m, " << frequency;
      }
    }
  }
  EXPECT_NEAR(heard(250, 90, 0.25, plain_head()).level, 7.9, 0.3);
}

// Kuhn's limit for low frequencies, 3 radii / speed of sound.
TEST(Ears, LargerHeadsHearLargerDifferences) {
  EXPECT_NEAR(heard(250, 90, 2, head(0.0544)).time, 476, 0.02 * 476);
  EXPECT_NEAR(heard(250, 90, 2, head(0.0759)).time, 664, 0.02 * 664);
}

TEST(Ears, SwapInAMirroredScene) {
  const std::vector<float> sound = tone(730, 0.2);
  for (const double azimuth : {7.0, 33.0, 90.0, 140.0}) {
    const Streams one = play(sound, [&](double) { return Eigen::Vector3d(direction(azimuth)); });
    const Streams other = play(
        sound, [&](double) { return Eigen::Vector3d(direction(azimuth).cwiseProduct(Eigen::Vector3d(1, -1, 1))); });
    EXPECT_EQ(one[0], other[1]);
    EXPECT_EQ(one[1], other[0]);
  }
}

TEST(Ears, SoundFallsOffWithDistance) {
  const auto level = [](double distance) {
    const Streams streams = play(tone(500, 0.5), [&](double) { return Eigen::Vector3d(distance, 0, 0); });
    return 20 * std::log10(std::abs(amplitude(streams[0], 500)));
  };
  EXPECT_NEAR(level(2) - level(1), -5.95, 0.1);
}

// 1 m from the middle of the head, round the sphere to ears at 100 degrees.
TEST(Ears, HearAClickAheadOnTime) {
  EXPECT_NEAR(ways_to(head(), Eigen::Vector3d(1, 0, 0))[0].delay, 2.962e-3, 0.1 / kRate);
  // Where it is heard: as early as the delay and no sample earlier, what lies between samples aside.
  const std::vector<float> pulse = [] {
    std::vector<float> samples(1600, 0.0F);
    samples[0] = 1;
    return samples;
  }();
  const Streams streams = play(pulse, [](double) { return Eigen::Vector3d(1, 0, 0); });
  std::size_t loudest = 0;
  for (std::size_t i = 0; i < streams[0].size(); ++i) {
    if (std::abs(streams[0][i]) > std::abs(streams[0][loudest])) loudest = i;
  }
  EXPECT_NEAR(static_cast<double>(loudest) / kRate, 2.962e-3, 0.7 / kRate);
}

TEST(Ears, HearApproachingSourcesHigher) {
  const double speed = 5, frequency = 1000;
  const Streams streams = play(tone(frequency, 1), [&](double t) { return Eigen::Vector3d(20 - speed * t, 0, 0); });
  // The phase that goes on between two stretches tells the frequency.
  const std::size_t n = 4000;
  const double nominal = 1014.6;
  const auto phase = [&](std::size_t first) {
    std::complex<double> sum = 0;
    for (std::size_t i = first; i < first + n; ++i) {
      const double weight = 0.5 - 0.5 * std::cos(2 * kPi * static_cast<double>(i - first) / n);
      sum += weight * static_cast<double>(streams[0][i]) *
             std::exp(std::complex<double>(0, -2 * kPi * nominal * static_cast<double>(i) / kRate));
    }
    return std::arg(sum);
  };
  const double drift = std::remainder(phase(11000) - phase(10000), 2 * kPi) / (2 * kPi) / (1000 / kRate);
  EXPECT_NEAR(nominal + drift, frequency * (1 + speed / 343), 1);
  // Everything that is no tone near that frequency: crackle.
  double worst = 0, main = 0;
  for (double f = 200; f < 7800; f += 4) {
    std::complex<double> sum = 0;
    for (std::size_t i = 8000; i < 8000 + n; ++i) {
      const double turn = 2 * kPi * static_cast<double>(i - 8000) / n;
      const double weight =
          0.35875 - 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) - 0.01168 * std::cos(3 * turn);
      sum += weight * static_cast<double>(streams[0][i]) *
             std::exp(std::complex<double>(0, -2 * kPi * f * static_cast<double>(i) / kRate));
    }
    (std::abs(f - nominal) < 40 ? main : worst) = std::max(std::abs(f - nominal) < 40 ? main : worst, std::abs(sum));
  }
  EXPECT_LT(20 * std::log10(worst / main), -40);
}

// Level in the left ear of a source 1 m ahead that looks along an axis.
double level_of(const Eigen::Vector3d& axis, double directivity, std::size_t own = Ears::kNone) {
  const std::vector<float> samples = tone(500, 0.5);
  sound::Queue queue(samples.size());
  queue.add(samples, 0);
  Ears ears(kTick, kRate, kTick, 1, own);
  std::vector<float> heard, block(kTick), other(kTick);
  for (std::size_t now = 0; now < samples.size(); now += kTick) {
    Source source{&queue, Eigen::Vector3d(1, 0, 0), now == 0, axis, directivity};
    ears.advance(head(), Span<const Source>(&source, 1), static_cast<std::int64_t>(now));
    ears.latest(0, block);
    ears.latest(1, other);
    EXPECT_EQ(block, other);
    heard.insert(heard.end(), block.begin(), block.end());
  }
  return 20 * std::log10(std::abs(amplitude(heard, 500)) + 1e-12);
}

// A cardioid gives half at its side, nothing behind; a figure of eight gives as much behind as ahead.
TEST(Ears, SourcesHaveDirections) {
  const Eigen::Vector3d ahead(-1, 0, 0), side(0, 1, 0), behind(1, 0, 0);
  const double alike = level_of(side, 0);
  EXPECT_NEAR(level_of(ahead, 0.5), alike, 1e-4);
  EXPECT_NEAR(level_of(side, 0.5), alike - 6.02, 0.01);
  EXPECT_LT(level_of(behind, 0.5), alike - 100);
  EXPECT_NEAR(level_of(behind, 0.25), alike - 6.02, 0.01);
  EXPECT_NEAR(level_of(behind, 1), alike, 0.01);
}

// 17 dB above the level at 1 m, wherever the mouth is.
TEST(Ears, HearTheirOwnVoiceLoud) { EXPECT_NEAR(level_of(Eigen::Vector3d(1, 0, 0), 0.25, 0), 17, 0.05); }

Blow wooden_blow(double onset) {
  constexpr int kHardWood = 6;  // row of kTimbreTable
  const sound::Solid wood = {1.1e10, 0.25, 1e-4, kHardWood};
  const sound::Struck block = {wood, 20, 50, 0.02, 0.12}, table = {wood, 0, 0, 1, 3};
  const sound::Strike blow = strike(block, table, 1);
  return {Eigen::Vector3d(0.6, 0.8, 0), onset, click(blow, 20, 0.02, 1), ringing(blow, block)};
}

TEST(Voices, AreHeardWithTheirFullEnergy) {
  // Far away the head's middle is all that counts; straight ahead both ears have the same filter.
  Blow blow = wooden_blow(10.3);
  blow.click.scale = 0;
  Ears ears(kTick, kRate, kTick, 0);
  const Head listener = head();
  ears.add(blow, listener, 0);
  const Ways ways = ways_to(listener, blow.place);
  double expected = 0;
  for (std::size_t i = 0; i < blow.ringing.count; ++i) {
    const sound::Mode& mode = blow.ringing.modes[i];
    const double gain = mode.gain * ways[0].gain * std::abs(response(ways[0], mode.frequency));
    expected += gain * gain * mode.decay / 27.6;
  }
  double sum = 0;
  for (std::int64_t now = 0; now < 32000; now += kTick) {
    ears.advance(listener, {}, now);
    std::array<float, kTick> block;
    ears.latest(0, block);
    for (const float sample : block) sum += std::pow(static_cast<double>(sample), 2) / kRate;
  }
  EXPECT_NEAR(sum / expected, 1, 0.02);
}

// A later blow is the same sound later: neither ticks nor parts of samples change it.
TEST(Voices, FollowFromTheirBeginning) {
  Ears one(kTick, kRate, 3200, 0), other(kTick, kRate, 3200, 0), fine(16, kRate, 3200, 0);
  const Head listener = head();
  one.add(wooden_blow(10.25), listener, 0);
  other.add(wooden_blow(50.25), listener, 0);
  fine.add(wooden_blow(10.25), listener, 0);
  for (std::int64_t now = 0; now < 3200; now += kTick) {
    one.advance(listener, {}, now);
    other.advance(listener, {}, now);
  }
  for (std::int64_t now = 0; now < 3200; now += 16) fine.advance(listener, {}, now);
  std::vector<float> a(3200), b(3200), c(3200);
  one.latest(0, a);
  other.latest(0, b);
  fine.latest(0, c);
  float largest = 0;
  for (const float sample : a) largest = std::max(largest, std::abs(sample));
  EXPECT_GT(largest, 0.05F);
  for (std::size_t i = 0; i + 40 < a.size(); ++i) {
    ASSERT_NEAR(a[i], b[i + 40], 1e-4 * largest) << i;
    ASSERT_NEAR(a[i], c[i], 1e-4 * largest) << i;
  }
}

TEST(Voices, FallSilent) {
  Ears ears(kTick, kRate, 1600, 0);
  const Head listener = head();
  ears.add(wooden_blow(0.5), listener, 0);
  for (std::int64_t now = 0; now < 160000; now += kTick) ears.advance(listener, {}, now);
  EXPECT_TRUE(ears.silent(1600));
}

// Heads of no infants may have any size.
class AnyHead : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Radii, AnyHead, ::testing::Values(1e-3, kRadius, 2.0, 300.0));

TEST_P(AnyHead, HearsPlausibleLevels) {
  const Head listener = head(GetParam());
  const double distance = 3 * GetParam() + 1;
  const Streams streams = play(
      tone(500, 3), [&](double) { return Eigen::Vector3d(distance * direction(30)); }, listener);
  for (const std::vector<float>& stream : streams) {
    for (const float sample : stream) ASSERT_LT(std::abs(sample), 3 / GetParam());
  }
}

TEST_P(AnyHead, ContinuesFromASavedState) {
  Ears one(kTick, kRate, 800, 0), other(kTick, kRate, 800, 0);
  const Head listener = head(GetParam());
  for (int i = 0; i < 40; ++i) one.add(wooden_blow(3.1 * i), listener, 0);  // more than there is room for
  one.advance(listener, {}, 0);
  ByteWriter counter;
  one.save(counter);
  std::vector<std::uint8_t> bytes(counter.size());
  ByteWriter to(bytes);
  one.save(to);
  ByteReader from(bytes);
  other.load(from);
  for (std::int64_t now = kTick; now < 1600; now += kTick) {
    one.advance(listener, {}, now);
    other.advance(listener, {}, now);
  }
  std::vector<float> a(800), b(800);
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    one.latest(ear, a);
    other.latest(ear, b);
    EXPECT_EQ(a, b);
  }
}

}  // namespace
}  // namespace mimo::hearing
