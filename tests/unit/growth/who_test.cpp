// Values of the standards against the WHO's own tables.
#include "growth/who.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "repository_paths.h"
#include "support/numbers.h"
#include "support/table.h"

namespace mimo::test {
namespace {

using growth::Measure;
using growth::Sex;

// Length in cm, weight in kg, head in cm at -2, 0 and 2 standard deviations, from the tables of z-scores that the WHO
// publishes (simplified field tables), one decimal.
struct Published {
  Measure measure;
  Sex sex;
  double age;
  double low, median, high;
};

const Published kPublished[] = {
    {Measure::kLength, Sex::kMale, 0, 46.1, 49.9, 53.7},  {Measure::kLength, Sex::kFemale, 0, 45.4, 49.1, 52.9},
    {Measure::kLength, Sex::kMale, 12, 71.0, 75.7, 80.5}, {Measure::kLength, Sex::kFemale, 24, 80.0, 86.4, 92.9},
    {Measure::kWeight, Sex::kMale, 0, 2.5, 3.3, 4.4},     {Measure::kWeight, Sex::kFemale, 0, 2.4, 3.2, 4.2},
    {Measure::kWeight, Sex::kMale, 12, 7.7, 9.6, 12.0},   {Measure::kWeight, Sex::kFemale, 24, 9.0, 11.5, 14.8},
    {Measure::kHead, Sex::kMale, 0, 31.9, 34.5, 37.0},    {Measure::kHead, Sex::kFemale, 12, 42.2, 44.9, 47.6},
};

TEST(Who, GivesTheValuesThatTheWhoPublishes) {
  constexpr double kRounded = 0.05 + 1e-9;
  for (const Published& row : kPublished) {
    SCOPED_TRACE(row.age);
    EXPECT_NEAR(who(row.measure, row.sex, row.age, -2), row.low, kRounded);
    EXPECT_NEAR(who(row.measure, row.sex, row.age, 0), row.median, kRounded);
    EXPECT_NEAR(who(row.measure, row.sex, row.age, 2), row.high, kRounded);
  }
}

TEST(Who, IsTheWhosFormulaAtEachMonth) {
  const std::map<std::string, Measure> measures = {
      {"length", Measure::kLength}, {"weight", Measure::kWeight}, {"head_circumference", Measure::kHead}};
  const Table table(MIMO_TEST_DATA "/../../src/growth/who_lms.csv");
  ASSERT_EQ(table.size(), 150u);
  for (const Table::Row& row : table.rows()) {
    const double l = row.number("L"), m = row.number("M"), s = row.number("S"), age = row.number("age_months");
    const Sex sex = row.text("sex") == "f" ? Sex::kFemale : Sex::kMale;
    for (const double z : {-3.0, -2.0, 0.0, 2.0, 3.0}) {
      EXPECT_TRUE(close(m * std::pow(1 + l * s * z, 1 / l), who(measures.at(row.text("measure")), sex, age, z)))
          << row.label() << ", z " << z;
    }
  }
}

TEST(Who, GivesTheMeanOfTheSexes) {
  const double girl = who(Measure::kWeight, Sex::kFemale, 7, 1), boy = who(Measure::kWeight, Sex::kMale, 7, 1);
  EXPECT_EQ(who(Measure::kWeight, Sex::kMean, 7, 1), (girl + boy) / 2);
}

TEST(Who, GrowsFromDayToDay) {
  for (const Measure measure : {Measure::kLength, Measure::kWeight, Measure::kHead}) {
    for (const Sex sex : {Sex::kFemale, Sex::kMale}) {
      for (int day = 1; day <= 730; ++day) {
        const double before = who(measure, sex, (day - 1) / 30.4375, 0);
        EXPECT_GT(who(measure, sex, day / 30.4375, 0), before) << day;
      }
    }
  }
}

TEST(Curve, PassesThroughItsPointsWithoutOvershoot) {
  const std::array<double, 5> x = {0, 1, 2.5, 3, 7}, y = {0.1, 0.3, 0.3, 0.9, 1.7};
  const growth::Curve curve(x, y);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(curve(x[i]), y[i]);
  double before = curve(0);
  for (int step = 0; step <= 700; ++step) {
    const double at = 0.01 * step;
    EXPECT_GE(curve(at), before);
    before = curve(at);
  }
  EXPECT_EQ(curve(1.7), 0.3);  // between equal points
}

// Three points on a parabola, 1, 4, 9 at 1, 2, 3: slopes of the two pieces are 3 and 5, so by the formulas of Fritsch
// and Butland 2, 2 * 3 * 5 / (3 + 5) = 3.75 and 6; in the middle of a piece a cubic is the mean of its ends plus an
// eighth of the width times the slopes' difference.
TEST(Curve, FollowsFritschAndButland) {
  const growth::Curve curve({1, 2, 3}, {1, 4, 9});
  EXPECT_NEAR(curve(1.5), 2.5 + (2 - 3.75) / 8, 1e-14);
  EXPECT_NEAR(curve(2.5), 6.5 + (3.75 - 6) / 8, 1e-14);
}

TEST(Drivers, AreExactly1At18Months) {
  const growth::Drivers drivers = growth::drivers({});
  EXPECT_EQ(drivers.l, 1);
  EXPECT_EQ(drivers.w, 1);
  EXPECT_EQ(drivers.h, 1);
  EXPECT_EQ(drivers.mass, 1);
}

}  // namespace
}  // namespace mimo::test
