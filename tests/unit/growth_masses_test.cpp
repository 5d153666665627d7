// How the mass of infants is spread over their parts.
#include <gtest/gtest.h>

#include <map>

#include "growth/growth.h"
#include "growth/mechanics.h"
#include "growth/sizes.h"
#include "support/infants.h"
#include "support/numbers.h"

namespace mimo::test {
namespace {

using growth::Growth;
using growth::Sex;
using growth::Skeleton;

class GrowthMasses : public ::testing::TestWithParam<std::string> {
 protected:
  const Skeleton& base() const { return infant(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Bodies, GrowthMasses, ::testing::Values("mitten", "fingers"));

const std::vector<std::string> kLegs = {"upper_leg", "lower_leg", "foot", "toes", "big_toe"};
const std::vector<std::string> kArms = {"upper_arm", "lower_arm"};

double share(const Skeleton& body, const std::vector<std::string>& bones) {
  return mass_of(body, bones) / growth::total_mass(body);
}

// Of the whole body's centre of mass over the soles, standing straight, over the stature.
double centre(const Skeleton& body) {
  double moment = 0;
  const auto bones = growth::poses(body, {});
  for (std::size_t i = 0; i < bones.size(); ++i) {
    for (const growth::Geom& geom : body.bones[i].geoms) {
      moment += geom.mass * (bones[i] * growth::pose_of(geom).translation()).z();
    }
  }
  return (moment / growth::total_mass(body) - growth::lowest_point(body, {})) / growth::stature(body);
}

// Newborns are top-heavy: the centre of mass falls with age, as a share of the stature.
TEST_P(GrowthMasses, CentreFallsWithAge) {
  for (const Sex sex : {Sex::kMean, Sex::kFemale, Sex::kMale}) {
    double before = 1;
    for (int step = 0; step <= 480; ++step) {
      Growth growth = aged(std::min(0.05 * step, 24.0));
      growth.sex = sex;
      const double now = centre(grown(base(), growth));
      EXPECT_LT(now, before) << "at " << growth.age << " months, sex " << static_cast<int>(sex);
      before = now;
    }
  }
}

// A quarter of the mass at birth is head (textbooks); bands of infants and crash dummies for the legs.
TEST(GrowthMassesOfMittens, AgreeWithInfantsHeadsAndLegs) {
  const Skeleton& base = infant("mitten");
  const std::map<double, double> heads = {{0, 0.25}, {12, 0.18}, {24, 0.16}};
  for (const auto& [age, head] : heads) EXPECT_NEAR(share(grown(base, aged(age)), {"head"}), head, 0.01) << age;
  EXPECT_NEAR(share(grown(base, aged(0)), kLegs), 0.18, 0.02);
  EXPECT_NEAR(share(grown(base, aged(24)), kLegs), 0.25, 0.02);
}

// kg, w weeks old: thigh .239 + .0124 w, shank .169 + .00416 w, foot .0522 + .00212 w, from 2 to 15 months (Sun and
// Jensen 1994). Schneider and Zernicke (1992) give a leg of 12 months 30 % less, of thighs 16 cm long and 23.5 cm
// around: .0691 + 2.9582 x .16 + 3.1541 x .235 - .6722 = .611 kg, shanks of 15 and 18.1 cm .318, feet of 11.5 x 4.8 cm
// .160.
TEST_P(GrowthMasses, LegsAgreeWithMeasurements) {
  const struct {
    double age, tolerance;  // months, share
  } rows[] = {{2, 0.06}, {3, 0.03}, {6, 0.04}, {9, 0.10}, {12, 0.15}};
  for (const auto& row : rows) {
    const double weeks = row.age * 30.4375 / 7;
    const double measured = 2 * (0.239 + 0.0124 * weeks + 0.169 + 0.00416 * weeks + 0.0522 + 0.00212 * weeks);
    EXPECT_TRUE(close(measured, mass_of(grown(base(), aged(row.age)), kLegs), {row.tolerance})) << row.age;
  }
  const Skeleton year = grown(base(), aged(12));
  EXPECT_GT(mass_of(year, kLegs), 2 * (0.611 + 0.318 + 0.160));
  EXPECT_LT(mass_of(year, kLegs), 2 * (0.884 + 0.385 + 0.162));
}

TEST(GrowthMassesOfMittens, FeetAgreeWithMeasurementsOfTheFirstHalfYear) {
  for (const double age : {0.0, 2.0, 3.0, 6.0}) {
    const double measured = 2 * (0.0522 + 0.00212 * age * 30.4375 / 7);
    const Skeleton body = grown(infant("mitten"), aged(age));
    EXPECT_TRUE(close(measured, mass_of(body, {"foot", "toes"}), {0.08})) << age;
  }
}

// What is spread was there before, and stays on both sides alike.
TEST_P(GrowthMasses, KeepTheirSum) {
  for (const double age : {0.0, 2.3, 9.0, 18.0, 24.0}) {
    const Skeleton body = grown(base(), aged(age)), even = fit(base(), aged(age)).skeleton;
    EXPECT_TRUE(close(growth::total_mass(even), growth::total_mass(body), {1e-12})) << age;
    for (const std::string& bone : kArms) EXPECT_EQ(mass_of(body, {bone}), mass_of(even, {bone})) << age;
  }
}

// Torque over the moment of the weight that a joint carries is what it is where all ages are equally dense.
TEST_P(GrowthMasses, LeaveStrengthOverWeight) {
  const Skeleton even = fit(base(), aged(1)).skeleton;
  Skeleton spread = even;
  spread_mass(spread, 1);
  const auto was = growth::loads(even), is = growth::loads(spread);
  for (std::size_t i = 0; i < even.motors.size(); ++i) {
    const growth::Motor &before = even.motors[i], &after = spread.motors[i];
    const double heavier = is.at(after.joint).moment / was.at(after.joint).moment;
    EXPECT_TRUE(close(before.gear * heavier, after.gear)) << after.name;
    EXPECT_TRUE(close(before.muscle[1] * heavier, after.muscle[1])) << after.name;
    EXPECT_TRUE(close(before.muscle[2] * heavier, after.muscle[2])) << after.name;
  }
}

TEST_P(GrowthMasses, RefuseAnInfantThatIsAllHead) {
  Skeleton body = base();
  growth::Parts(body).geom("head").mass = 30;
  try {
    spread_mass(body, 0);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::kInvalidArgument);
    EXPECT_NE(error.message().find("a head of 36.78 kg"), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace mimo::test
