// Voices by age: Kent and Murray 1982; a tube of 7.5 to 9.5 cm, 353 m/s.
#include "growth/voice.h"

#include <gtest/gtest.h>

namespace mimo::growth {
namespace {

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
