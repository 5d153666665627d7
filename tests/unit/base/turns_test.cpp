#include "base/turns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mimo {
namespace {

using Eigen::Quaterniond;

constexpr double kRounding = 1e-15;

// i j = k, and the products of two general ones by Hamilton's rule, calculated by hand.
TEST(Turns, FollowEachOther) {
  const Quaterniond k = turn_after({0, 1, 0, 0}, {0, 0, 1, 0});
  EXPECT_EQ(k.w(), 0);
  EXPECT_EQ(k.z(), 1);
  const Quaterniond q = turn_after({1, 2, 3, 4}, {5, 6, 7, 8});
  EXPECT_EQ(q.w(), 5 - 12 - 21 - 32);
  EXPECT_EQ(q.x(), 6 + 10 + 24 - 28);
  EXPECT_EQ(q.y(), 7 - 16 + 15 + 24);
  EXPECT_EQ(q.z(), 8 + 14 - 18 + 20);
}

TEST(Turns, BecomeOfLengthOne) {
  const Quaterniond q = normal_turn({1, 5, 1, 3});  // of length 6
  EXPECT_NEAR(q.w(), 1 / 6.0, kRounding);
  EXPECT_NEAR(q.x(), 5 / 6.0, kRounding);
  EXPECT_NEAR(q.z(), 0.5, kRounding);
  EXPECT_EQ(normal_turn({0, 0, 0, 0}).w(), 0);
}

// 1e16 + 1 - 1e16 is 0 or 1 by the order: that of Eigen with vectors of two on x86-64.
TEST(Turns, AddInOneOrder) {
  const Quaterniond q = turn_after({1e8, 1e8, 1, 1}, {1e8, 1e8, -1, 0});
  EXPECT_EQ(q.w(), (1e16 + 1) - (0 + 1e16));
}

}  // namespace
}  // namespace mimo
