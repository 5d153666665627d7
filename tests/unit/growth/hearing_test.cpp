// What infants hear at an age.
#include "growth/hearing.h"

#include <gtest/gtest.h>

namespace mimo::growth {
namespace {

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
TEST(Hearing, LiesBetweenThem) {
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

}  // namespace
}  // namespace mimo::growth
