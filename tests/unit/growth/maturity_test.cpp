// How eyes, ears and voices are at an age.

#include "growth/maturity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mimo::growth {
namespace {

// Between the ages of the table logarithms go in straight lines.
TEST(Eyesight, FollowsItsTables) {
  EXPECT_NEAR(eye_maturity_at(0).acuity, 0.70, 1e-9);
  EXPECT_NEAR(eye_maturity_at(0.5).acuity, 0.785, 5e-4);
  EXPECT_NEAR(eye_maturity_at(3).acuity, 2.434, 5e-4);
  EXPECT_NEAR(eye_maturity_at(24).acuity, 11.1, 1e-9);
  EXPECT_NEAR(eye_maturity_at(0).peak_contrast, 2, 1e-9);
  EXPECT_NEAR(eye_maturity_at(1.5).peak_contrast, 3.74, 5e-3);
  EXPECT_NEAR(eye_maturity_at(18).peak_contrast, 28.28, 5e-3);
}

TEST(Eyesight, SeesColourFromTheSecondMonth) {
  EXPECT_EQ(eye_maturity_at(0).chroma, 0);
  EXPECT_EQ(eye_maturity_at(1).chroma, 0);
  EXPECT_EQ(eye_maturity_at(2).chroma, 0.5);
  EXPECT_EQ(eye_maturity_at(3).chroma, 1);
  EXPECT_EQ(eye_maturity_at(24).chroma, 1);
}

TEST(Eyesight, FollowsFasterChanges) {
  EXPECT_DOUBLE_EQ(eye_maturity_at(0).flicker, 4);
  EXPECT_DOUBLE_EQ(eye_maturity_at(4).flicker, 8);
  EXPECT_DOUBLE_EQ(eye_maturity_at(24).flicker, 15);
}

TEST(Eyesight, Sharpens) {
  for (double age = 0; age < 24; age += 0.25) {
    EXPECT_GT(eye_maturity_at(age + 0.25).acuity, eye_maturity_at(age).acuity);
    EXPECT_GT(eye_maturity_at(age + 0.25).peak_contrast, eye_maturity_at(age).peak_contrast);
  }
}

// Adults' thresholds (ISO 226:2003) and what was found of infants above them.
TEST(Hearing, FollowsItsTables) {
  EXPECT_NEAR(hearing_threshold(0, 500), 4.4 + 45, 1e-9);  // Sinnott 1983
  EXPECT_NEAR(hearing_threshold(0, 4000), -5.4 + 32, 1e-9);
  // At 500 Hz adults' 4.4 dB and 45 of newborns, 18, 15 and 14 of 3, 6 and 12 months.
  const double at_500_hertz[][2] = {{0, 49.4}, {3, 22.4}, {6, 19.4}, {12, 18.4}};
  for (const auto& [age, level] : at_500_hertz) EXPECT_NEAR(hearing_threshold(age, 500), level, 1e-9) << age;
  EXPECT_NEAR(hearing_threshold(3, 8000), 12.6 + 30, 1e-9);  // Olsho 1988
  EXPECT_NEAR(hearing_threshold(6, 1000), 2.4 + 14, 1e-9);   // Nozza and Wilson 1984
  EXPECT_NEAR(hearing_threshold(12, 4000), -5.4 + 6, 1e-9);
}

// Straight lines in age and in the logarithm of frequency: worked out by hand, from numbers of one decimal.
TEST(Hearing, InterpolatesBetweenTheTables) {
  EXPECT_NEAR(hearing_threshold(9, 1000), 2.4 + 13, 1e-9);
  EXPECT_NEAR(hearing_threshold(0, 1046.6), 42.4, 0.1);
  EXPECT_NEAR(hearing_threshold(24, 3065.1), -1.0, 0.1);
  EXPECT_NEAR(hearing_threshold(0, 147.7), 67.0, 0.1);
  EXPECT_EQ(hearing_threshold(0, 60), hearing_threshold(0, 100));
}

TEST(Hearing, GetsBetterWithAge) {
  for (double frequency = 125; frequency <= 8000; frequency *= 1.3) {
    for (double age = 0; age < 24; age += 1) {
      EXPECT_GE(hearing_threshold(age, frequency), hearing_threshold(age + 1, frequency)) << age << " " << frequency;
    }
  }
}

// Voices by age: Kent and Murray 1982; a tube of 7.5 to 9.5 cm, 353 m/s.
TEST(Voices, HaveThePitchOfTheirAge) {
  EXPECT_EQ(vocal_pitch(3), 445);
  EXPECT_EQ(vocal_pitch(6), 450);
  EXPECT_EQ(vocal_pitch(9), 415);
}

TEST(Voices, HaveTheFormantsOfTheirAge) {
  const auto newborn = vocal_formants(0), old = vocal_formants(24);
  const double first[] = {1177, 3530, 5883}, last[] = {929, 2787, 4645};
  for (std::size_t i = 0; i < kFormants; ++i) {
    EXPECT_NEAR(newborn[i], first[i], 0.7);
    EXPECT_NEAR(old[i], last[i], 0.7);
  }
}

}  // namespace
}  // namespace mimo::growth
