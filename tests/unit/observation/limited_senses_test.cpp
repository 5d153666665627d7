// Which fields limits concern, and what they do to numbers that are known.
#include "observation/limited_senses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/fail.h"
#include "observation/observer.h"
#include "unit/observation/parts.h"

namespace mimo::observation {
namespace {

// Two agents with two fields each.
class LimitedSensesTest : public ::testing::Test {
 protected:
  LimitedSensesTest()
      : sense_(Share::kTask, {signal("anna/touch", 1), signal("anna/touch/slip", 1), signal("anna/touching", 1),
                              signal("ben/touch", 1)}),
        limited_(observer_) {
    observer_.add(sense_);
    block_.resize(observer_.layout().bytes());
  }

  void limit(const std::vector<PathLimits>& paths, const Clock& clock = {0.01, 1, true}) {
    limited_.add("anna/", paths, {}, clock);
    limited_.make_room();
  }
  // What is sensed of a value, field by field.
  std::vector<float> sensed(float value, std::uint64_t step) {
    const mjData_ data{value};
    if (step == 0) limited_.begin(mjModel_{}, data, block_.data(), kNoise);
    if (step > 0) limited_.step(mjModel_{}, data, block_.data(), kNoise, step, nullptr);
    std::vector<float> values;
    for (std::size_t i = 0; i < observer_.layout().size(); ++i) {
      values.push_back(*reinterpret_cast<const float*>(block_.data() + observer_.layout()[i].offset));
    }
    return values;
  }

  static constexpr std::uint64_t kNoise = 1;
  Signals sense_;
  Observer observer_;
  LimitedSenses limited_;
  std::vector<std::uint8_t> block_;
};

using Values = std::vector<float>;

TEST_F(LimitedSensesTest, ApplyToAFieldAndAllBelowItsPath) {
  limit({{"touch", {0.5, 0, 0, 0}}});
  EXPECT_EQ(sensed(8, 0), (Values{4, 4, 8, 8}));
}

TEST_F(LimitedSensesTest, TheLastLimitCounts) {
  limit({{"touch", {0.5, 0, 0, 0}}, {"touch/slip", {0.25, 0, 0, 0}}});
  EXPECT_EQ(sensed(8, 0), (Values{4, 2, 8, 8}));
}

TEST_F(LimitedSensesTest, DelayByWholeSteps) {
  limit({{"touching", {1, 0, 0, 0.02}}});
  EXPECT_EQ(sensed(1, 0), (Values{1, 1, 1, 1}));
  EXPECT_EQ(sensed(2, 1), (Values{2, 2, 1, 2}));
  EXPECT_EQ(sensed(3, 2), (Values{3, 3, 1, 3}));
  EXPECT_EQ(sensed(4, 3), (Values{4, 4, 2, 4}));
}

TEST_F(LimitedSensesTest, KeepNothingWithoutLimits) {
  limit({});
  EXPECT_FALSE(limited_.wants(1));
  std::vector<Section> sections;
  limited_.list(sections);
  EXPECT_TRUE(sections.empty());
}

// 24 ms are nearest to two steps of 10 ms, 4 ms to none.
TEST_F(LimitedSensesTest, DelaysAreRoundedToSteps) {
  limit({{"touching", {1, 0, 0, 0.024}}, {"touch", {1, 0, 0, 0.004}}});
  sensed(1, 0);
  sensed(2, 1);
  EXPECT_EQ(sensed(3, 2), (Values{3, 3, 1, 3}));
  EXPECT_EQ(sensed(4, 3), (Values{4, 4, 2, 4}));
}

// Steps of three ticks. A field that is 4 ticks late is sensed at ticks 2, 5, 8 alone, and read at 3, 6, 9.
TEST_F(LimitedSensesTest, DelayByTicksWithinAStep) {
  limit({{"touching", {1, 0, 0, 0.04}}}, {0.01, 3, true});
  const auto passed = [&](std::uint64_t tick) {
    const bool wanted = limited_.wants(tick);
    if (wanted) limited_.pass(mjModel_{}, mjData_{static_cast<float>(tick)}, tick, nullptr);
    return wanted;
  };
  sensed(0, 0);
  EXPECT_FALSE(passed(1));
  EXPECT_TRUE(passed(2));
  EXPECT_EQ(sensed(3, 3)[2], 0);
  EXPECT_FALSE(passed(4));
  EXPECT_TRUE(passed(5));
  EXPECT_EQ(sensed(6, 6)[2], 2);
  EXPECT_TRUE(passed(8));
  EXPECT_EQ(sensed(9, 9)[2], 5);
}

// One element at once, one a tick, one five ticks late; in steps of two ticks.
TEST(DelayLine, DelaysEachElementSeparately) {
  Signals sense(Share::kTouch, {signal("touch", 3)});
  Observer observer;
  observer.add(sense);
  LimitedSenses limited(observer);
  limited.add("", {}, [](const Field&) { return Nature{{0, 0.01, 0.05}, {}}; }, {0.01, 2, true});
  limited.make_room();
  std::vector<std::uint8_t> block(observer.layout().bytes());
  const auto* seen = reinterpret_cast<const float*>(block.data());
  limited.begin(mjModel_{}, mjData_{0}, block.data(), 1);
  for (std::uint64_t tick = 1; tick <= 20; ++tick) {
    const mjData_ data{static_cast<float>(tick)};
    if (tick % 2 == 1) {
      ASSERT_TRUE(limited.wants(tick));
      limited.pass(mjModel_{}, data, tick, nullptr);
      continue;
    }
    limited.step(mjModel_{}, data, block.data(), 1, tick, nullptr);
    const auto now = static_cast<float>(tick);
    EXPECT_EQ(seen[0], now);
    EXPECT_EQ(seen[1], now - 1);
    EXPECT_EQ(seen[2], std::max(0.0F, now - 5));
  }
  const DelayLine* delay = limited.delay(observer.layout()[0]);
  ASSERT_NE(delay, nullptr);
  std::vector<double> seconds(3);
  delay->lateness().tell(seconds);
  EXPECT_EQ(seconds, (std::vector<double>{0, 0.01, 0.05}));
  EXPECT_EQ(delay->lateness().most(), 5u);
}

// Attached senses see the ends of steps only: 30 ms are nearest to two steps of 20 ms, 24 ms to one.
TEST_F(LimitedSensesTest, RoundDelaysToStepsWithoutTicks) {
  limit({{"touching", {1, 0, 0, 0.03}}, {"touch", {1, 0, 0, 0.024}}}, {0.01, 2, false});
  for (int step = 0; step <= 6; ++step) {
    const std::vector<float> now = sensed(static_cast<float>(step), 2 * static_cast<std::uint64_t>(step));
    EXPECT_EQ(now[0], std::max(0.0F, static_cast<float>(step) - 1));
    EXPECT_EQ(now[2], std::max(0.0F, static_cast<float>(step) - 2));
  }
}

TEST_F(LimitedSensesTest, NoiseMayGrowWithTheSignal) {
  limit({{"touch", {1, 0, 0, 0, 0.5}}});
  const std::vector<float> small = sensed(1, 3), large = sensed(10, 3);
  EXPECT_NE(small[0], 1);
  EXPECT_NEAR(large[0], 10 * small[0], 1e-5);
}

TEST_F(LimitedSensesTest, StartAgainAfterForgetting) {
  limit({{"touching", {1, 0, 0, 0.02}}});
  std::vector<Section> sections;
  limited_.list(sections);
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_EQ(sections[0].name, "delay/anna/touching");
  sensed(1, 0);
  sensed(2, 1);
  sections[0].forget();
  EXPECT_EQ(sensed(3, 2)[2], 3);
  EXPECT_EQ(sensed(4, 3)[2], 3);
  EXPECT_EQ(sensed(5, 4)[2], 3);
  EXPECT_EQ(sensed(6, 5)[2], 4);
}

TEST_F(LimitedSensesTest, RefuseMoreThan2000Steps) {
  try {
    limit({{"touching", {1, 0, 0, 20.01}}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), "delay is 20.01 s, which is 2001 steps of 0.01 s, expected 0 to 2000 steps");
  }
}

TEST_F(LimitedSensesTest, RefuseAnUnknownPath) {
  try {
    limit({{"taste", {0, 0, 0, 0}}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kNotFound);
    EXPECT_EQ(error.message(), "limits: no field \"taste\" and none below; there are: touch, touch/slip, touching");
  }
}

}  // namespace
}  // namespace mimo::observation
