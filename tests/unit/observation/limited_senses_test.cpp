// Which fields limits concern, and what they do to numbers that are known.
#include "observation/limited_senses.h"

#include <gtest/gtest.h>

#include "base/status.h"
#include "observation/observer.h"
#include "unit/observation/parts.h"

namespace mimo::observation {
namespace {

// Two agents with two fields each.
class LimitedSensesTest : public ::testing::Test {
 protected:
  LimitedSensesTest()
      : sense_(Share::kTask, {signal("anna/touch", 1), signal("anna/touch/slip", 1), signal("anna/touching", 1),
                              signal("ben/touch", 1)}) {
    observer_.add(sense_);
    block_.resize(observer_.layout().bytes());
  }

  void limit(const std::vector<PathLimits>& paths) {
    limited_.add(observer_.layout(), "anna/", paths);
    limited_.make_room(observer_.layout());
    limited_.start(Random(1));
  }
  // What is sensed of a value, field by field.
  std::vector<float> sensed(float value, std::uint64_t step) {
    observer_.observe(mjModel_{}, mjData_{value}, block_.data(), nullptr);
    step == 0 ? limited_.begin(block_.data()) : limited_.step(block_.data(), step);
    std::vector<float> values;
    for (std::size_t i = 0; i < observer_.layout().size(); ++i) {
      values.push_back(*reinterpret_cast<const float*>(block_.data() + observer_.layout()[i].offset));
    }
    return values;
  }

  Signals sense_;
  Observer observer_;
  LimitedSenses limited_;
  std::vector<std::uint8_t> block_;
};

using Values = std::vector<float>;

TEST_F(LimitedSensesTest, ConcernAFieldAndAllBelowItsPath) {
  limit({{"touch", {0.5, 0, 0, 0}}});
  EXPECT_EQ(sensed(8, 0), (Values{4, 4, 8, 8}));
}

TEST_F(LimitedSensesTest, TheLastOneCounts) {
  limit({{"touch", {0.5, 0, 0, 0}}, {"touch/slip", {0.25, 0, 0, 0}}});
  EXPECT_EQ(sensed(8, 0), (Values{4, 2, 8, 8}));
}

TEST_F(LimitedSensesTest, AreLateByWholeSteps) {
  limit({{"touching", {1, 0, 0, 2}}});
  ASSERT_TRUE(limited_.late());
  EXPECT_EQ(sensed(1, 0), (Values{1, 1, 1, 1}));
  EXPECT_EQ(sensed(2, 1), (Values{2, 2, 1, 2}));
  EXPECT_EQ(sensed(3, 2), (Values{3, 3, 1, 3}));
  EXPECT_EQ(sensed(4, 3), (Values{4, 4, 2, 4}));
}

TEST_F(LimitedSensesTest, WithoutAnyNothingIsKept) {
  limit({});
  EXPECT_FALSE(limited_.late());
  ByteWriter counter;
  limited_.save(counter);
  EXPECT_EQ(counter.size(), 0u);
}

TEST_F(LimitedSensesTest, RefuseAPathThatLeadsNowhere) {
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
