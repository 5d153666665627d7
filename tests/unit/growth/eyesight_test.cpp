// How well eyes see at an age.
#include "growth/eyesight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mimo::growth {
namespace {

// Between the ages of the table logarithms go in straight lines.
TEST(Eyesight, FollowsItsTables) {
  EXPECT_NEAR(eyesight_at(0).acuity, 0.70, 1e-9);
  EXPECT_NEAR(eyesight_at(0.5).acuity, 0.785, 5e-4);
  EXPECT_NEAR(eyesight_at(3).acuity, 2.434, 5e-4);
  EXPECT_NEAR(eyesight_at(24).acuity, 11.1, 1e-9);
  EXPECT_NEAR(eyesight_at(0).peak_contrast, 2, 1e-9);
  EXPECT_NEAR(eyesight_at(1.5).peak_contrast, 3.74, 5e-3);
  EXPECT_NEAR(eyesight_at(18).peak_contrast, 28.28, 5e-3);
}

TEST(Eyesight, SeesColourFromTheSecondMonth) {
  EXPECT_EQ(eyesight_at(0).chroma, 0);
  EXPECT_EQ(eyesight_at(1).chroma, 0);
  EXPECT_EQ(eyesight_at(2).chroma, 0.5);
  EXPECT_EQ(eyesight_at(3).chroma, 1);
  EXPECT_EQ(eyesight_at(24).chroma, 1);
}

TEST(Eyesight, FollowsFasterChanges) {
  EXPECT_DOUBLE_EQ(eyesight_at(0).flicker, 4);
  EXPECT_DOUBLE_EQ(eyesight_at(4).flicker, 8);
  EXPECT_DOUBLE_EQ(eyesight_at(24).flicker, 15);
}

TEST(Eyesight, Sharpens) {
  for (double age = 0; age < 24; age += 0.25) {
    EXPECT_GT(eyesight_at(age + 0.25).acuity, eyesight_at(age).acuity);
    EXPECT_GT(eyesight_at(age + 0.25).peak_contrast, eyesight_at(age).peak_contrast);
  }
}

}  // namespace
}  // namespace mimo::growth
