// An infant's voice: level, pitch, vowels, silence. Expected numbers: Kent and Murray 1982 (pitch), a tube of 7.5 cm at
// birth and 9.5 cm at 24 months that is closed at one end (formants), 82 dB for a cry.
#include "sound/vocal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "base/numbers.h"
#include "sound/air.h"

namespace mimo::sound {
namespace {

constexpr double kRate = 16000;
constexpr std::size_t kTick = 80;
constexpr std::array<double, kFormants> kFormantsThen = {1000, 3000, 5000};

Vocal voice(double pitch = 445) { return Vocal(pitch, kFormantsThen, kRate, kTick, 0); }

std::vector<float> say(Vocal& voice, const Utterance& told, double seconds) {
  std::vector<float> said;
  for (int i = 0; i < std::lround(seconds * kRate / kTick); ++i) {
    std::vector<float> block(kTick, 0.0F);
    voice.utter(told, block);
    said.insert(said.end(), block.begin(), block.end());
  }
  return said;
}

// From when its muscles have come to what they were told.
std::vector<float> settled(double pitch, const Utterance& told) {
  Vocal speaker = voice(pitch);
  say(speaker, told, 0.4);
  return say(speaker, told, 1);
}

double level(const std::vector<float>& samples) {
  double sum = 0;
  for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
  return 10 * std::log10(sum / static_cast<double>(samples.size()) / (kReference * kReference));
}

double power(const std::vector<float>& samples, double frequency) {
  std::complex<double> sum = 0;
  const auto count = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double weight = 0.5 - 0.5 * std::cos(2 * kPi * static_cast<double>(i) / count);
    sum += weight * static_cast<double>(samples[i]) *
           std::polar(1.0, -2 * kPi * frequency * static_cast<double>(i) / kRate);
  }
  return std::norm(sum);
}

double band(const std::vector<float>& samples, double low, double high) {
  double sum = 0;
  for (double f = low; f < high; f += 2) sum += power(samples, f);
  return sum;
}

// Whatever the vowel and the pitch.
TEST(Voice, HasTheGivenLoudness) {
  for (const double pitch : {300.0, 445.0, 629.0}) {
    for (const Utterance& vowel : {Utterance{1, 0, 1, 1}, Utterance{1, 0, 1.3, 0.7}, Utterance{1, 0, 0.7, 1.3}}) {
      EXPECT_NEAR(level(settled(pitch, vowel)), 82, 0.7) << pitch << " " << vowel.opening;
    }
  }
  EXPECT_NEAR(level(settled(445, {0.5, 0, 1, 1})), 82 - 12.04, 0.7);  // a quarter of the pressure
}

TEST(Voice, HasTheGivenPitch) {
  for (const double octaves : {-0.5, 0.0, 0.5}) {
    const std::vector<float> said = settled(445, {1, octaves, 1, 1});
    const double expected = 445 * std::pow(2, octaves);
    double best = 0, found = 0;
    for (double f = 0.8 * expected; f < 1.2 * expected; f += 1) {
      const double here = power(said, f);
      if (here > best) best = here, found = f;
    }
    EXPECT_NEAR(found, expected, 0.01 * expected);
    EXPECT_GT(best, 100 * power(said, 0.5 * expected));  // nothing an octave below
  }
}

// A second formant of 3 kHz moves from 2.1 to 3.9 kHz, a first one of 1 kHz from 0.7 to 1.3.
TEST(Voice, ShapesVowels) {
  const std::vector<float> back = settled(300, {1, 0, 1, 0.7}), front = settled(300, {1, 0, 1, 1.3});
  EXPECT_GT(band(back, 1900, 2300), 10 * band(front, 1900, 2300));
  EXPECT_GT(band(front, 3700, 4100), 10 * band(back, 3700, 4100));
  const std::vector<float> closed = settled(300, {1, 0, 0.7, 1}), open = settled(300, {1, 0, 1.3, 1});
  EXPECT_GT(band(closed, 550, 750) / band(closed, 1100, 1300), 10 * band(open, 550, 750) / band(open, 1100, 1300));
}

TEST(Voice, FallsSilent) {
  Vocal speaker = voice();
  std::vector<float> block(kTick);
  EXPECT_FALSE(speaker.utter({}, block));
  say(speaker, {1, 0, 1, 1}, 0.2);
  EXPECT_TRUE(speaker.utter({}, block));
  say(speaker, {}, 1);
  EXPECT_FALSE(speaker.utter({}, block));
}

TEST(Voice, ContinuesFromASavedState) {
  Vocal one = voice(), other = voice();
  say(one, {0.8, 0.2, 1.1, 0.9}, 0.123);
  ByteWriter counter;
  one.save(counter);
  std::vector<std::uint8_t> bytes(counter.size());
  ByteWriter to(bytes);
  one.save(to);
  ByteReader from(bytes);
  other.load(from);
  EXPECT_EQ(say(one, {0.4, -0.2, 1, 1}, 0.1), say(other, {0.4, -0.2, 1, 1}, 0.1));
}

}  // namespace
}  // namespace mimo::sound
