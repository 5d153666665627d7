// Strength, range of motion and tone of infants by the WHO's model.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/numbers.h"
#include "growth/growth.h"
#include "growth/mechanics.h"
#include "growth/sizes.h"
#include "growth/skeleton.h"
#include "support/infants.h"
#include "support/numbers.h"

namespace mimo::test {
namespace {

using growth::Growth;
using growth::Skeleton;

constexpr double kGravity = 9.81;

class GrowthStrength : public ::testing::TestWithParam<std::string> {
 protected:
  const Skeleton& base() const { return infant(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Bodies, GrowthStrength, ::testing::Values("mitten", "fingers"));

const growth::Motor& motor(const Skeleton& skeleton, const std::string& name) {
  for (const growth::Motor& motor : skeleton.motors) {
    if (motor.name == name) return motor;
  }
  throw std::runtime_error(name);
}

growth::Joint& joint(Skeleton& skeleton, const std::string& name) { return growth::Parts(skeleton).joint(name); }

growth::Load load(const Skeleton& skeleton, const std::string& joint) { return growth::loads(skeleton).at(joint); }

// Torque over the moment of the limb's weight, held out straight.
double relative_strength(const Skeleton& skeleton, const std::string& of_motor) {
  const growth::Motor& it = motor(skeleton, of_motor);
  return it.gear / (kGravity * load(skeleton, it.joint).moment);
}

bool moves_neck(const growth::Motor& motor) { return motor.name.find("head_") != std::string::npos; }

// Cross-section times length: of limbs that of the bone, of all else the volume. And as much more as the joint carries
// more than if all parts were as dense as at 18 months.
TEST_P(GrowthStrength, ScalesWithMuscleVolumeAtEqualSpecificStrength) {
  Growth growth = aged(4);
  growth.strength_exponent = 0;
  const Skeleton body = grown(base(), growth), even = fit(base(), growth).skeleton;
  const auto expect_ratio = [&](const char* name, const char* geom, double (*bulk)(const growth::Geom&)) {
    const double ratio = bulk(growth::geom(body, geom)) / bulk(growth::geom(base(), geom));
    EXPECT_LT(ratio, 0.8);
    const std::string joint = motor(body, name).joint;
    const double heavier = load(body, joint).moment / load(even, joint).moment;
    EXPECT_TRUE(close(ratio * heavier, motor(body, name).gear / motor(base(), name).gear)) << name;
  };
  const auto limb = [](const growth::Geom& geom) { return geom.size[0] * geom.size[0] * geom.size[1]; };
  expect_ratio("act:left_elbow", "left_larm", limb);
  expect_ratio("act:right_shoulder_internal", "right_uarm1", limb);
  expect_ratio("act:right_knee", "right_lower_leg1", limb);
  expect_ratio("act:left_hip_flex", "left_upper_leg1", limb);
  expect_ratio("act:left_wrist_flexion", "left_hand1", growth::volume);
  expect_ratio("act:hip_bend", "cb", growth::volume);
  expect_ratio("act:right_eye_vertical", "right_eye", growth::volume);
  expect_ratio("act:left_foot_flexion", "left_foot2", growth::volume);
}

// Worked out by hand for the model: k = (median length over that at 18 months)^1.7.
TEST_P(GrowthStrength, OfACrossSectionGrowsWithPhysiologicalAge) {
  const std::map<double, double> worked_out = {{0, 0.429}, {1, 0.500},  {3, 0.605}, {6, 0.711},
                                               {9, 0.792}, {12, 0.866}, {18, 1},    {24, 1.120}};
  for (const auto& [age, k] : worked_out) {
    Growth growth;
    growth.physiological_age = age;
    const Skeleton body = grown(base(), growth);
    EXPECT_NEAR(motor(body, "act:left_elbow").gear / motor(base(), "act:left_elbow").gear, k, 6e-4) << age;
    EXPECT_EQ(motor(body, "act:left_eye_vertical").gear, motor(base(), "act:left_eye_vertical").gear) << age;
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
      EXPECT_EQ(body.bones[i].position, base().bones[i].position);
      for (std::size_t g = 0; g < body.bones[i].geoms.size(); ++g) {
        EXPECT_EQ(body.bones[i].geoms[g].mass, base().bones[i].geoms[g].mass);
      }
    }
  }
}

TEST_P(GrowthStrength, OverWeightNeverFallsWithAge) {
  for (const char* name : {"act:left_elbow", "act:left_shoulder_abduction", "act:left_knee", "act:left_hip_flex"}) {
    double before = 0;
    for (int step = 0; step <= 48; ++step) {
      const double age = 0.5 * step;
      const double now = relative_strength(grown(base(), aged(age)), name);
      EXPECT_GE(now, 0.999 * before) << name << " at " << age << " months";
      before = now;
    }
  }
}

// Worked out apart from this library, for mitten hands.
TEST(GrowthStrengthOfMittens, StrengthOverWeightEqualsTheCalculation) {
  struct Row {
    double age, elbow, shoulder, knee, hip;
  };
  for (const Row& row : {Row{0, 12.3, 4.05, 14.2, 3.39},
                         {1, 13.0, 4.34, 15.6, 3.63},
                         {3, 13.9, 4.72, 17.5, 3.94},
                         {6, 14.9, 5.10, 18.6, 4.16},
                         {12, 16.3, 5.65, 19.2, 4.37},
                         {18, 17.4, 6.09, 19.4, 4.48},
                         {24, 18.4, 6.45, 19.6, 4.55}}) {
    const Skeleton body = grown(infant("mitten"), aged(row.age));
    EXPECT_TRUE(close(row.elbow, relative_strength(body, "act:left_elbow"), {0.01})) << row.age;
    EXPECT_TRUE(close(row.shoulder, relative_strength(body, "act:left_shoulder_abduction"), {0.01})) << row.age;
    // The shin of young infants lies a little higher than there, so that its end does not stick out of the sole.
    EXPECT_TRUE(close(row.knee, relative_strength(body, "act:left_knee"), {0.02})) << row.age;
    EXPECT_TRUE(close(row.hip, relative_strength(body, "act:left_hip_flex"), {0.01})) << row.age;
  }
}

// Torque of the neck over the head's moment about its hinge; 3.04 at 18 months.
TEST_P(GrowthStrength, NeckHoldsTheHeadAsInfantsDo) {
  const std::map<double, double> ratios = {{0, 0.5}, {1, 0.75}, {2, 1.0},  {3, 1.3},   {4, 1.5},
                                           {6, 2.0}, {9, 2.5},  {12, 2.8}, {18, 3.04}, {24, 3.1}};
  const double at_18 = relative_strength(base(), "act:head_tilt");
  if (GetParam() == "mitten") {
    EXPECT_NEAR(at_18, 3.04, 0.01);
  }
  for (const auto& [age, ratio] : ratios) {
    const Skeleton body = grown(base(), aged(age));
    EXPECT_TRUE(close(ratio, 3.04 * relative_strength(body, "act:head_tilt") / at_18, {1e-3})) << age;
  }
  Growth strong = aged(2);
  strong.neck_strength = 2;
  const Skeleton usual = grown(base(), aged(2)), stronger = grown(base(), strong);
  for (std::size_t i = 0; i < usual.motors.size(); ++i) {
    const double factor = moves_neck(usual.motors[i]) ? 2 : 1;
    EXPECT_TRUE(close(factor * usual.motors[i].gear, stronger.motors[i].gear)) << usual.motors[i].name;
  }
}

TEST_P(GrowthStrength, MusclesScaleWithMotors) {
  const Skeleton body = grown(base(), aged(5));
  for (std::size_t i = 0; i < body.motors.size(); ++i) {
    const growth::Motor &is = body.motors[i], &was = base().motors[i];
    EXPECT_EQ(is.muscle[0], was.muscle[0]) << is.name;
    EXPECT_TRUE(close(was.muscle[1] * is.gear / was.gear, is.muscle[1])) << is.name;
    EXPECT_TRUE(close(was.muscle[2] * is.gear / was.gear, is.muscle[2])) << is.name;
  }
}

TEST_P(GrowthStrength, LimitsAgreeWithYoungInfants) {
  struct Row {
    const char* name;
    int end;
    double age, degrees;
  };
  for (const Row& row : {Row{"robot:left_knee", 1, 0, -21.4},
                         {"robot:left_knee", 1, 3, -10.7},
                         {"robot:right_knee", 1, 4.5, -7.0},
                         {"robot:left_knee", 1, 12, 4},
                         {"robot:left_hip1", 1, 0, -30},
                         {"robot:left_hip1", 1, 1.4, -19},
                         {"robot:left_hip1", 1, 9, 0},
                         {"robot:left_hip1", 1, 10.5, 10},
                         {"robot:left_elbow", 1, 0, -19},
                         {"robot:left_elbow", 1, 3, -7},
                         {"robot:left_elbow", 1, 6, -1},
                         {"robot:left_foot1", 1, 0, 62},
                         {"robot:left_foot1", 0, 0, -25},
                         {"robot:left_foot1", 0, 6, -44}}) {
    Skeleton body = grown(base(), aged(row.age));
    EXPECT_NEAR(joint(body, row.name).range[row.end] / kDegree, row.degrees, 1e-9) << row.name << ", " << row.age;
  }
}

// Ankles alone bend further up in newborns than later.
TEST_P(GrowthStrength, LimitsOnlyEverWiden) {
  Skeleton before = grown(base(), aged(0));
  for (int step = 0; step <= 96; ++step) {
    const Skeleton now = grown(base(), aged(0.25 * step));
    for (std::size_t i = 0; i < now.bones.size(); ++i) {
      for (std::size_t k = 0; k < now.bones[i].joints.size(); ++k) {
        const growth::Joint &is = now.bones[i].joints[k], &was = before.bones[i].joints[k],
                            &last = base().bones[i].joints[k];
        EXPECT_LT(is.range[0], is.range[1]);
        EXPECT_LE(is.range[0], was.range[0]) << is.name;
        EXPECT_GE(is.range[0], last.range[0]) << is.name;
        EXPECT_GE(is.springref, last.range[0]) << is.name;
        if (growth::plain_name(is.name) == "foot1") continue;
        EXPECT_GE(is.range[1], was.range[1]) << is.name;
        EXPECT_LE(is.range[1], last.range[1]) << is.name;
      }
    }
    before = now;
  }
}

TEST_P(GrowthStrength, ContractureScalesTheMissingRange) {
  Growth growth = aged(0);
  growth.contracture = 0;
  Skeleton free = grown(base(), growth);
  EXPECT_NEAR(joint(free, "robot:left_knee").range[1] / kDegree, 4, 1e-9);
  EXPECT_NEAR(joint(free, "robot:left_knee").springref / kDegree, -30, 1e-9);
  growth.contracture = 0.5;
  Skeleton half = grown(base(), growth);
  EXPECT_NEAR(joint(half, "robot:left_knee").range[1] / kDegree, (4 - 21.4) / 2, 1e-9);
  EXPECT_NEAR(joint(half, "robot:left_knee").springref / kDegree, -30 - (4 + 21.4) / 2, 1e-9);
}

TEST_P(GrowthStrength, StiffnessHoldsTheSameShareOfWeightButForTheToneOfNewborns) {
  const std::map<double, double> tones = {{0, 1.5}, {3, 1.25}, {6, 1}, {12, 1}};
  for (const auto& [age, tone] : tones) {
    Skeleton body = grown(base(), aged(age)), was = base();
    for (const char* name : {"robot:left_elbow", "robot:right_hip2", "robot:hip_bend1", "robot:head_tilt"}) {
      const growth::Load now = load(body, name), then = load(base(), name);
      const growth::Joint &is = joint(body, name), &old = joint(was, name);
      const double moment = now.moment / then.moment, inertia = now.inertia / then.inertia;
      EXPECT_TRUE(close(old.stiffness * moment * tone, is.stiffness)) << name;
      EXPECT_TRUE(close(old.frictionloss * moment, is.frictionloss)) << name;
      // As damped as before: damping over twice the root of stiffness times inertia.
      EXPECT_TRUE(close(old.damping / std::sqrt(old.stiffness * then.inertia),
                        is.damping / std::sqrt(is.stiffness * now.inertia)))
          << name;
      EXPECT_TRUE(close(old.armature * std::max(0.01, inertia), is.armature)) << name;
    }
  }
}

}  // namespace
}  // namespace mimo::test
