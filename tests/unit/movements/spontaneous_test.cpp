// Spontaneous movements as commands: what depends on what, which kinds there are at which age.
#include "movements/spontaneous.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace mimo::movements {
namespace {

const std::vector<std::string> kMotors = {"hip_bend",
                                          "head_swivel",
                                          "left_eye_horizontal",
                                          "right_shoulder_abduction",
                                          "right_elbow",
                                          "left_shoulder_abduction",
                                          "right_hip_flex",
                                          "right_knee",
                                          "left_hip_flex",
                                          "left_knee",
                                          "left_foot_flexion"};
constexpr std::size_t kEye = 2, kShoulder = 3, kRightHip = 6, kRightKnee = 7, kLeftHip = 8, kLeftKnee = 9;

std::vector<float> at(double age, double time, std::uint32_t which, std::uint64_t seed = 1) {
  std::vector<float> commands(kMotors.size());
  Spontaneous(kMotors, age).command(seed, time, which, commands);
  return commands;
}

// Of one motor, every 10 ms.
std::vector<float> course(double age, std::size_t motor, std::uint32_t which, double seconds, std::uint64_t seed = 1) {
  const Spontaneous infant(kMotors, age);
  std::vector<float> commands(kMotors.size()), course;
  for (int i = 0; i < static_cast<int>(100 * seconds); ++i) {
    infant.command(seed, 0.01 * i, which, commands);
    course.push_back(commands[motor]);
  }
  return course;
}

double strongest(const std::vector<float>& course) {
  double most = 0;
  for (const float value : course) most = std::max(most, std::abs(static_cast<double>(value)));
  return most;
}

constexpr std::uint32_t kAll = 31;

TEST(Spontaneous, LimbsAreKnownByTheirMotors) {
  EXPECT_EQ(limb_of("hip_bend"), Limb::kTrunk);
  EXPECT_EQ(limb_of("left_hip_flex"), Limb::kLeftLeg);
  EXPECT_EQ(limb_of("right_big_toe"), Limb::kRightLeg);
  EXPECT_EQ(limb_of("left_ff_knuckle"), Limb::kLeftArm);
  EXPECT_EQ(limb_of("head_tilt_side"), Limb::kHead);
  EXPECT_EQ(limb_of("left_eye_vertical"), Limb::kNone);
  EXPECT_EQ(limb_of("wheel"), Limb::kNone);
  EXPECT_EQ(limb_of(""), Limb::kNone);
}

TEST(Spontaneous, FollowsFromSeedTimeAgeAndName) {
  EXPECT_EQ(at(3, 12.34, kAll), at(3, 12.34, kAll));
  EXPECT_NE(at(3, 12.34, kAll, 2), at(3, 12.34, kAll, 3));
  EXPECT_NE(at(3, 12.34, kAll), at(3, 12.54, kAll));
  // The other motors of a body do not count.
  std::vector<float> alone(1);
  Spontaneous({"right_knee"}, 3).command(1, 12.34, kAll, alone);
  EXPECT_EQ(alone[0], at(3, 12.34, kAll)[kRightKnee]);
}

TEST(Spontaneous, StaysWithinTheMotorsStrength) {
  for (const double age : {0.0, 1.0, 3.0, 6.0, 12.0, 24.0}) {
    for (std::size_t motor = 0; motor < kMotors.size(); ++motor) {
      const double most = strongest(course(age, motor, kAll, 30));
      EXPECT_LE(most, 1);
      EXPECT_EQ(most > 0, motor != kEye) << kMotors[motor] << " at " << age;
    }
  }
}

// Einspieler et al. 2016: fidgety movements occur at 3 to 5 months after term.
TEST(Spontaneous, FidgetsAreOfThreeToFiveMonths) {
  for (const double age : {0.0, 1.0, 6.0, 12.0}) {
    EXPECT_EQ(strongest(course(age, kShoulder, MIMO_MOVEMENT_FIDGETS, 10)), 0) << age;
  }
  for (const double age : {3.0, 4.0, 5.0}) {
    EXPECT_GT(strongest(course(age, kShoulder, MIMO_MOVEMENT_FIDGETS, 10)), 0.02) << age;
  }
}

TEST(Spontaneous, StartlesAreOfTheFirstFourMonthsAndShared) {
  const std::vector<float> arm = course(0, kShoulder, MIMO_MOVEMENT_STARTLES, 200),
                           leg = course(0, kRightKnee, MIMO_MOVEMENT_STARTLES, 200);
  EXPECT_GT(strongest(arm), 0.3);
  for (std::size_t i = 0; i < arm.size(); ++i) EXPECT_EQ(arm[i] != 0, leg[i] != 0) << "all limbs at once";
  EXPECT_EQ(strongest(course(4, kShoulder, MIMO_MOVEMENT_STARTLES, 200)), 0);
}

// Hip and knee of a leg bend and stretch together; of the other leg they kick at other times.
TEST(Spontaneous, KicksAreOfOneLeg) {
  const std::vector<float> hip = course(3, kRightHip, MIMO_MOVEMENT_KICKS, 60),
                           knee = course(3, kRightKnee, MIMO_MOVEMENT_KICKS, 60),
                           other = course(3, kLeftHip, MIMO_MOVEMENT_KICKS, 60);
  double together = 0, apart = 0, own = 0;
  for (std::size_t i = 0; i < hip.size(); ++i) {
    together += hip[i] * knee[i];
    apart += hip[i] * other[i];
    own += hip[i] * hip[i];
  }
  EXPECT_NEAR(together / own, 0.7, 1e-4) << "the knee has 0.7 of the hip's share";
  EXPECT_LT(std::abs(apart / own), 0.3);
  EXPECT_EQ(strongest(course(3, kShoulder, MIMO_MOVEMENT_KICKS, 60)), 0);
  EXPECT_GT(strongest(course(3, kLeftKnee, MIMO_MOVEMENT_KICKS, 60)), 0.1);
}

// DiMercurio et al. 2018: infants on their backs moved about half of the time.
TEST(Spontaneous, GeneralMovementsWaxAndWane) {
  const std::vector<float> hip = course(1, kRightHip, MIMO_MOVEMENT_GENERAL, 300);
  const auto resting = static_cast<double>(std::count(hip.begin(), hip.end(), 0.0F)) / static_cast<double>(hip.size());
  EXPECT_GT(resting, 0.25);
  EXPECT_LT(resting, 0.75);
}

TEST(Spontaneous, KindsAddUp) {
  std::vector<float> sum(kMotors.size(), 0);
  for (std::uint32_t bit = 1; bit <= MIMO_MOVEMENT_TWITCHES; bit *= 2) {
    const std::vector<float> one = at(3, 7.77, bit);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one[i];
  }
  const std::vector<float> all = at(3, 7.77, kAll);
  for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(all[i], std::clamp(sum[i], -1.0F, 1.0F), 1e-6);
}

}  // namespace
}  // namespace mimo::movements
