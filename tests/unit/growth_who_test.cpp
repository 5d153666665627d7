// Sizes and masses of both bodies by the WHO's model.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "growth/growth.h"
#include "growth/mechanics.h"
#include "growth/sizes.h"
#include "growth/skeleton.h"
#include "growth/who.h"
#include "repository_paths.h"
#include "support/infants.h"
#include "support/numbers.h"
#include "support/table.h"

namespace mimo::test {
namespace {

using growth::Growth;
using growth::Sex;
using growth::Skeleton;

const std::map<std::string, Sex> kSexes = {{"mean", Sex::kMean}, {"f", Sex::kFemale}, {"m", Sex::kMale}};

class GrowthOf : public ::testing::TestWithParam<std::string> {
 protected:
  const Skeleton& base() const { return infant(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Bodies, GrowthOf, ::testing::Values("mitten", "fingers"));

// All numbers of a body, each with a name.
using Numbers = std::vector<std::pair<std::string, double>>;

template <typename Values>
void add(Numbers& numbers, const std::string& name, const Values& values) {
  for (const double value : values) numbers.emplace_back(name, value);
}

Numbers sizes_of(const Skeleton& skeleton) {
  Numbers numbers;
  for (const growth::Bone& bone : skeleton.bones) {
    add(numbers, bone.name + " position", bone.position);
    for (const growth::Geom& geom : bone.geoms) {
      add(numbers, geom.name + " size", geom.size);
      add(numbers, geom.name + " position", geom.position);
      add(numbers, geom.name + " mass", std::array<double, 1>{geom.mass});
    }
    for (const growth::Joint& joint : bone.joints) add(numbers, joint.name + " position", joint.position);
    for (const growth::Mark& mark : bone.marks) add(numbers, mark.name + " position", mark.position);
  }
  return numbers;
}

Numbers numbers_of(const Skeleton& skeleton) {
  Numbers numbers = sizes_of(skeleton);
  for (const growth::Bone& bone : skeleton.bones) {
    for (const growth::Joint& joint : bone.joints) {
      add(numbers, joint.name + " range", joint.range);
      add(numbers, joint.name,
          std::array<double, 5>{joint.springref, joint.stiffness, joint.damping, joint.frictionloss, joint.armature});
    }
  }
  for (const growth::Motor& motor : skeleton.motors) {
    add(numbers, motor.name + " gear", std::array<double, 1>{motor.gear});
    add(numbers, motor.name + " muscle", motor.muscle);
  }
  return numbers;
}

TEST_P(GrowthOf, EqualsTheBuiltInBodyAt18Months) {
  const Numbers is = numbers_of(grown(base(), {})), was = numbers_of(base());
  ASSERT_GT(was.size(), 500u);
  EXPECT_EQ(is, was);
  EXPECT_EQ(fit(base(), {}).closure, 1);
}

// Columns of the worked-out table, of a body of mitten hands.
std::map<std::string, double> columns_of(const Skeleton& base, const Growth& growth) {
  // Its shares of mass are those of parts that are as dense as at 18 months.
  const growth::Fit fitted = fit(base, growth);
  const Skeleton body = grown(base, growth), even = fitted.skeleton;
  const double stature = growth::stature(body), mass = growth::total_mass(body);
  const auto place = [](const Skeleton& skeleton, const char* bone) { return growth::bone(skeleton, bone).position; };
  const auto longer = [&](const char* bone) { return place(body, bone)[2] / place(base, bone)[2]; };
  const auto wider = [&](const char* geom) {
    return growth::geom(body, geom).size[0] / growth::geom(base, geom).size[0];
  };
  const double head = 2 * growth::geom(body, "head").size[0];
  const growth::Drivers drivers = growth::drivers(growth);
  const growth::Lengths lengths = growth::lengths(base, drivers, growth.age, 1);
  return {{"WHO_length_cm", drivers.length},
          {"WHO_weight_kg", drivers.weight},
          {"WHO_head_cm", drivers.head},
          {"length_ratio_l", drivers.l},
          {"slenderness_ratio_w", drivers.w},
          {"head_ratio_h", drivers.h},
          {"sitting_share", growth::sitting_share(growth.age)},
          {"stature_m", stature},
          {"total_mass_kg", mass},
          {"open_mass_kg", growth::total_mass(growth::resized(base, lengths, growth::girths(drivers, 1)))},
          {"girth_closure", fitted.closure},
          {"head_diameter_m", head},
          {"head_diameter_over_stature", head / stature},
          {"head_mass_share", mass_of(even, {"head"}) / mass},
          {"arms_mass_share", mass_of(even, {"upper_arm", "lower_arm", "hand", "fingers"}) / mass},
          {"legs_mass_share", mass_of(even, {"upper_leg", "lower_leg", "foot", "toes"}) / mass},
          {"trunk_factor", longer("upper_body")},
          {"thigh_length_m", -place(body, "left_lower_leg")[2]},
          {"shank_length_m", growth::geom(body, "left_lower_leg1").size[1] /
                                 growth::geom(base, "left_lower_leg1").size[1] * -place(base, "left_foot")[2]},
          {"leg_closure", lengths.leg_closure},
          {"upper_arm_factor", longer("left_lower_arm")},
          {"forearm_factor", longer("left_hand")},
          {"hand_factor", longer("left_fingers")},
          {"foot_factor", place(body, "left_toes")[0] / place(base, "left_toes")[0]},
          {"chest_girth", wider("ub2")},
          {"waist_girth", wider("cb")},
          {"hip_girth", wider("lb")},
          {"upper_arm_girth", wider("left_uarm1")},
          {"forearm_girth", wider("left_larm")},
          {"thigh_girth", wider("left_upper_leg1")},
          {"calf_girth", wider("left_lower_leg1")},
          {"ankle_girth", wider("left_lower_leg2")}};
}

// Four digits each.
TEST(GrowthProportions, EqualTheCalculatedOnes) {
  const Skeleton& base = infant("mitten");
  const Table table(MIMO_TEST_DATA "/growth/proportions.csv");
  ASSERT_EQ(table.size(), 84u);
  for (const Table::Row& row : table.rows()) {
    Growth growth = aged(row.number("age_months"));
    growth.sex = kSexes.at(row.text("sex"));
    const std::map<std::string, double> columns = columns_of(base, growth);
    EXPECT_EQ(columns.size(), table.columns().size() - 2);
    for (const auto& [name, value] : columns) {
      EXPECT_TRUE(close(row.number(name), value, {1e-3})) << row.label() << ", " << name;
    }
  }
}

TEST_P(GrowthOf, HasTheWhosLengthAndWeightForEveryMonthAndSex) {
  const double stature = growth::stature(base()), mass = growth::total_mass(base());
  const double length_18 = who(growth::Measure::kLength, Sex::kMean, 18, 0);
  const double weight_18 = who(growth::Measure::kWeight, Sex::kMean, 18, 0);
  for (const auto& [name, sex] : kSexes) {
    for (int month = 0; month <= 24; ++month) {
      for (const double z : {-2.0, 0.0, 2.0}) {
        Growth growth = aged(month);
        growth.sex = sex;
        growth.z_length = growth.z_weight = growth.z_head = z;
        const Skeleton body = grown(base(), growth);
        const double length = who(growth::Measure::kLength, sex, month, z);
        const double weight = who(growth::Measure::kWeight, sex, month, z);
        EXPECT_TRUE(close(length / length_18, growth::stature(body) / stature, {1e-3})) << name << month << ", " << z;
        EXPECT_TRUE(close(weight / weight_18, growth::total_mass(body) / mass, {1e-9})) << name << month << ", " << z;
      }
    }
  }
}

TEST_P(GrowthOf, HasTheWhosAbsoluteLengthAndWeightOnRequest) {
  for (const double age : {0.0, 3.0, 12.0, 18.0, 24.0}) {
    Growth growth = aged(age);
    growth.absolute = true;
    const Skeleton body = grown(base(), growth);
    const growth::Drivers who = growth::drivers(growth);
    EXPECT_TRUE(close(who.length / 100, growth::stature(body), {1e-3})) << age;
    EXPECT_TRUE(close(who.weight, growth::total_mass(body), {1e-9})) << age;
  }
}

TEST_P(GrowthOf, GrowsContinuously) {
  constexpr double kStep = 0.05, kJump = 0.005;
  std::vector<Numbers> ages;
  for (int step = 0; step <= 480; ++step) ages.push_back(sizes_of(grown(base(), aged(std::min(kStep * step, 24.0)))));
  for (std::size_t i = 0; i < ages[0].size(); ++i) {
    for (std::size_t k = 1; k < ages.size(); ++k) {
      const double before = std::abs(ages[k - 1][i].second), now = std::abs(ages[k][i].second);
      ASSERT_GE(now, before) << ages[k][i].first << " from " << kStep * static_cast<double>(k - 1) << " months";
      if (k < 2) continue;
      const double bend = now - 2 * before + std::abs(ages[k - 2][i].second);
      ASSERT_LE(std::abs(bend), kJump * now)
          << ages[k][i].first << " at " << kStep * static_cast<double>(k) << " months";
    }
  }
}

TEST_P(GrowthOf, IsSymmetric) {
  const Skeleton body = grown(base(), aged(2.3));
  int compared = 0;
  for (const growth::Bone& left : body.bones) {
    if (left.name.rfind("left_", 0) != 0) continue;
    const growth::Bone& right = growth::bone(body, "right_" + left.name.substr(5));
    EXPECT_EQ(left.position[0], right.position[0]) << left.name;
    EXPECT_EQ(std::abs(left.position[1]), std::abs(right.position[1])) << left.name;
    EXPECT_EQ(left.position[2], right.position[2]) << left.name;
    for (std::size_t i = 0; i < left.geoms.size(); ++i) {
      EXPECT_EQ(left.geoms[i].size, right.geoms[i].size) << left.geoms[i].name;
      EXPECT_EQ(left.geoms[i].mass, right.geoms[i].mass) << left.geoms[i].name;
    }
    for (std::size_t i = 0; i < left.joints.size(); ++i) {
      EXPECT_EQ(left.joints[i].range, right.joints[i].range) << left.joints[i].name;
      EXPECT_EQ(left.joints[i].springref, right.joints[i].springref) << left.joints[i].name;
      EXPECT_TRUE(close(left.joints[i].stiffness, right.joints[i].stiffness)) << left.joints[i].name;
      EXPECT_TRUE(close(left.joints[i].armature, right.joints[i].armature)) << left.joints[i].name;
    }
    ++compared;
  }
  EXPECT_GE(compared, 9);
}

// Newborns' circumferences of chest, hip, arm and calf, hand and foot length of other studies than those that the
// exponents are fitted to, cm; beside them those of the survey's infants of 18 months (Snyder et al. 1977), to which
// the body is in proportion.
TEST(GrowthProportions, AgreeWithMeasuredNewborns) {
  const Skeleton &base = infant("mitten"), body = grown(base, aged(0));
  const auto wider = [&](const char* geom) {
    return growth::geom(body, geom).size[0] / growth::geom(base, geom).size[0];
  };
  const auto place = [](const Skeleton& skeleton, const char* bone) { return growth::bone(skeleton, bone).position; };
  EXPECT_NEAR(46.8 * wider("ub2"), 33, 2);
  EXPECT_NEAR(47.7 * wider("lb"), 31.5, 2);
  EXPECT_NEAR(14.7 * wider("left_uarm1"), 10.3, 0.8);
  EXPECT_NEAR(18.4 * wider("left_lower_leg1"), 11.0, 0.9);
  EXPECT_NEAR(9.3 * place(body, "left_fingers")[2] / place(base, "left_fingers")[2], 6.1, 0.6);
  EXPECT_NEAR(11.9 * place(body, "left_toes")[0] / place(base, "left_toes")[0], 7.4, 0.6);
}

// The forearm ends where the wrist bends up and down, whatever of the hand lies above that.
TEST_P(GrowthOf, HasTheWristAtTheEndOfTheForearm) {
  const Skeleton body = grown(base(), aged(1));
  const double longer = growth::lengths(base(), growth::drivers(aged(1)), 1, 1).forearm;
  const auto wrist = [](const Skeleton& skeleton) {
    const growth::Bone& hand = growth::bone(skeleton, "left_hand");
    double lowest = 0;
    for (const growth::Joint& joint : hand.joints) lowest = std::min(lowest, joint.position[2]);
    return hand.position[2] + lowest;
  };
  EXPECT_TRUE(close(wrist(base()) * longer, wrist(body)));
}

// What does not fit together is refused, and nothing else is turned inside out.
TEST_P(GrowthOf, HasPositiveSizesForEveryPossibleCombination) {
  int fits = 0;
  for (const double age : {0.0, 1.0, 6.0, 18.0, 24.0}) {
    for (const double z_length : {-3.0, 0.0, 3.0}) {
      for (const double z_weight : {-3.0, 0.0, 3.0}) {
        for (const double z_head : {-3.0, 0.0, 3.0}) {
          Growth growth = aged(age);
          growth.z_length = z_length;
          growth.z_weight = z_weight;
          growth.z_head = z_head;
          try {
            for (const growth::Bone& bone : grown(base(), growth).bones) {
              for (const growth::Geom& geom : bone.geoms) {
                EXPECT_GT(geom.mass, 0) << geom.name;
                EXPECT_GT(geom.size[0], 0) << geom.name;
                if (geom.shape != growth::GeomShape::kSphere) {
                  EXPECT_GT(geom.size[1], 0) << geom.name;
                }
              }
            }
            ++fits;
          } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::kInvalidArgument);
          }
        }
      }
    }
  }
  EXPECT_GT(fits, 60);
}

TEST_P(GrowthOf, RefusesImpossibleCombinations) {
  const auto expect_refused = [](const Skeleton& base, const Growth& growth, const char* why) {
    try {
      grown(base, growth);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::kInvalidArgument);
      EXPECT_NE(error.message().find(why), std::string::npos) << error.message();
    }
  };
  Growth ball = aged(3);
  ball.z_length = -3;
  ball.z_weight = 3;
  expect_refused(base(), ball, "no infant of 54.4 cm weighs 8.7");

  // Of 24 kg 15 are head. A newborn's is 0.73^3 of it, 5.8 kg of the 7.5 that it should weigh: what is left for the
  // rest is two thirds of what the rest weighs before girths are fitted, so they would have to be about 0.8 of it.
  Skeleton heavy = base();
  growth::Parts(heavy).geom("head").mass = 15;
  expect_refused(heavy, aged(0), "no infant of 49.5 cm with a head of 34.2 cm weighs 3.29 kg");
}

TEST_P(GrowthOf, RefusesABodyWithChangedParts) {
  const auto expect_refused = [&](const char* name, const std::function<void(Skeleton&)>& change) {
    Skeleton changed = base();
    change(changed);
    try {
      grown(changed, aged(6));
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::kUnsupported);
      EXPECT_NE(error.message().find("\"" + std::string(name) + "\""), std::string::npos) << error.message();
    }
  };
  expect_refused("tail", [](Skeleton& it) { it.bones.back().name = "tail"; });
  expect_refused("belt", [](Skeleton& it) { it.bones[1].geoms[0].name = "belt"; });
  expect_refused("act:wag", [](Skeleton& it) { it.motors[0].name = "act:wag"; });
}

}  // namespace
}  // namespace mimo::test
