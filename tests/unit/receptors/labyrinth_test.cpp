// The labyrinth's afferents against the numbers of their sources.
#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.h"
#include "receptors/canals.h"
#include "receptors/gravity_estimate.h"
#include "receptors/maculae.h"

namespace mimo::receptors {
namespace {

using Eigen::Vector3d;

constexpr double kTick = 0.005;
constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr double kG = 9.80665;

// Seconds of one motion.
void turn(Canals& canals, const Vector3d& velocity, double seconds) {
  for (int i = 0; i < std::lround(seconds / kTick); ++i) canals.advance(velocity);
}

double over_rest(const Canals& canals, std::size_t canal, Afferent type) {
  return canals.rate(canal, type) - resting_rate_of_canal(type);
}

// About the canal's own axis at 60 degrees a second, so that the cosine is 1. K T2/T1 = 0.4366 of Schneider et al. 2015
// times 60, falling to its e-th part in each 5.7 s: 26.18, 21.98, 9.64, 3.55, 1.30 spikes/s.
TEST(Canals, ATurnThatGoesOnFades) {
  Canals canals(kTick);
  canals.rest(Vector3d::Zero());
  const Vector3d about = 60 * kDegree * canal_axis(1);
  canals.advance(about);  // the onset
  turn(canals, about, kTick);
  EXPECT_NEAR(over_rest(canals, 1, Afferent::kRegular), 26.18, 0.03);
  double before = kTick;
  const double known[][2] = {{1, 21.98}, {5.7, 9.64}, {11.4, 3.55}, {17.1, 1.30}};
  for (const auto& [at, rate] : known) {
    turn(canals, about, at - before);
    before = at;
    EXPECT_NEAR(over_rest(canals, 1, Afferent::kRegular), rate, 0.02) << at;
  }
}

// After a long turn the stop tells the opposite of what its start told.
TEST(Canals, AStopTellsTheOpposite) {
  Canals canals(kTick);
  canals.rest(60 * kDegree * canal_axis(1));
  canals.advance(Vector3d::Zero());
  canals.advance(Vector3d::Zero());
  EXPECT_NEAR(over_rest(canals, 1, Afferent::kRegular), -26.18, 0.03);
}

// Components of the directions of Della Santina et al. 2005: yaw to the left, pitch nose down, roll right side down.
TEST(Canals, TellWhichWay) {
  const double known[3][kCanals] = {{-0.590, -0.316, -0.696, 0.589, 0.329, 0.692},
                                    {0.788, -0.041, -0.668, 0.789, -0.036, -0.666},
                                    {-0.180, 0.948, -0.263, 0.173, -0.944, 0.278}};
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < kCanals; ++i) EXPECT_NEAR(canal_axis(i)[axis], known[axis][i], 0.001) << axis << i;
  }
  Canals canals(kTick);
  canals.rest(Vector3d::Zero());
  canals.advance({0, 0, 1});
  EXPECT_GT(over_rest(canals, 1, Afferent::kRegular), 0);
  EXPECT_LT(over_rest(canals, 4, Afferent::kRegular), 0);
}

// Amplitude and lead of the answer to a sine of 1 deg/s about a canal, in steps that hide nothing.
struct Answer {
  double amplitude, lead;  // spikes/s, degrees
};
Answer canal_answer(double hertz, Afferent type) {
  constexpr double kFine = 5e-4;
  Canals canals(kFine);
  canals.rest(Vector3d::Zero());
  const double turn = 2 * 180 * kDegree * hertz;
  const int cycles = hertz < 0.05 ? 3 : 6, each = static_cast<int>(1 / hertz / kFine);
  double sine = 0, cosine = 0;
  for (int i = 1; i <= cycles * each; ++i) {
    const double at = turn * i * kFine;
    canals.advance(std::sin(at) * kDegree * canal_axis(0));
    if (i <= (cycles - 1) * each) continue;
    sine += 2 * over_rest(canals, 0, type) * std::sin(at) / each;
    cosine += 2 * over_rest(canals, 0, type) * std::cos(at) / each;
  }
  return {std::hypot(sine, cosine), std::atan2(cosine, sine) / kDegree};
}

// |H| and phase of Schneider's transfer functions, computed from their constants. Their pole T2 is left out here, as it
// lies below the physics step: what it does to both is taken off again. Steps of 0.5 ms add up to 0.7 % and half a
// degree.
void expect_answers(Afferent type, double left_out, const double (&known)[4][3]) {
  for (const auto& [hertz, gain, lead] : known) {
    const Answer answer = canal_answer(hertz, type);
    const double pole = 2 * kPi * hertz * left_out;
    EXPECT_NEAR(answer.amplitude, gain * std::hypot(1, pole), 0.008 * gain) << hertz;
    EXPECT_NEAR(answer.lead, lead + std::atan(pole) / kDegree, 0.6) << hertz;
  }
}

TEST(Canals, FollowTheirTransferFunction) {
  expect_answers(Afferent::kRegular, 0.0027,
                 {{0.01, 0.147, 70.4}, {0.1, 0.421, 16.1}, {1, 0.439, 6.9}, {5, 0.4965, 24.3}});
  expect_answers(Afferent::kIrregular, 0.0006,
                 {{0.01, 0.183, 70.4}, {0.1, 0.522, 16.7}, {1, 0.551, 12.1}, {5, 0.744, 42.5}});
}

// Inhibition ends at silence, excitation does not (Ewald's second law).
TEST(Canals, InhibitionStopsAtSilence) {
  Canals canals(kTick);
  canals.rest(Vector3d::Zero());
  turn(canals, {0, 0, -10}, 2 * kTick);
  EXPECT_EQ(canals.rate(1, Afferent::kRegular), 0);
  EXPECT_GT(canals.rate(4, Afferent::kRegular), 250);
}

constexpr std::size_t kUtricle = 0, kSaccule = 1;

// The static gain of the regular ones is 46.165 spikes/s per g: lying on the right ear gives the left utricle's outward
// cells as much, takes it from the right one's, and the saccule's upward cells lose it.
TEST(Maculae, ATiltIsACosine) {
  for (int degrees = 0; degrees <= 90; degrees += 10) {
    const double angle = degrees * kDegree;
    const Vector3d force(0, std::sin(angle) * kG, std::cos(angle) * kG);
    Maculae left(true, kTick), right(false, kTick);
    left.rest(force);
    right.rest(force);
    EXPECT_NEAR(left.rate(kUtricle, 1, Afferent::kRegular), 70 + 46.165 * std::sin(angle), 1e-9);
    EXPECT_NEAR(right.rate(kUtricle, 1, Afferent::kRegular), 70 - 46.165 * std::sin(angle), 1e-9);
    EXPECT_NEAR(left.rate(kSaccule, 0, Afferent::kRegular), 70 + 46.165 * std::cos(angle), 1e-9);
    EXPECT_NEAR(left.rate(kSaccule, 1, Afferent::kRegular), 70, 1e-9);
  }
}

double macula_gain(double hertz, Afferent type, double tick) {
  Maculae macula(true, tick);
  macula.rest(Vector3d::Zero());
  const double turn = 2 * 180 * kDegree * hertz;
  const int each = static_cast<int>(std::lround(1 / hertz / tick));
  double sine = 0, cosine = 0;
  for (int i = 1; i <= 4 * each; ++i) {
    const double at = turn * i * tick;
    macula.advance({0, 0.2 * kG * std::sin(at), 0});
    if (i <= 3 * each) continue;
    const double over = macula.rate(kUtricle, 1, type) - kRestingRateOfMacula;
    sine += 2 * over * std::sin(at) / each;
    cosine += 2 * over * std::cos(at) / each;
  }
  return std::hypot(sine, cosine) / 0.2;
}

// |H| of Schneider's fractional transfer functions: 57.3 and 66.1 (spikes/s)/g at 0.1 and 1 Hz, regular; 97.7 and 196.8
// irregular, whose fit is good to 3.8 %. The same at another tick: the filters are exact.
TEST(Maculae, FollowTheirTransferFunction) {
  EXPECT_NEAR(macula_gain(0.1, Afferent::kRegular, 1e-3), 57.3, 0.02 * 57.3);
  EXPECT_NEAR(macula_gain(1, Afferent::kRegular, 1e-3), 66.1, 0.02 * 66.1);
  EXPECT_NEAR(macula_gain(0.1, Afferent::kIrregular, 1e-3), 97.7, 0.05 * 97.7);
  EXPECT_NEAR(macula_gain(1, Afferent::kIrregular, 1e-3), 196.8, 0.05 * 196.8);
  EXPECT_NEAR(macula_gain(1, Afferent::kIrregular, 1e-2), macula_gain(1, Afferent::kIrregular, 1e-3), 1);
}

// A first-order lag of 1.5 s lets at most a / (2 pi f 1.5 s) of a shaking of a through: 2 g at 5 Hz 0.042 g.
TEST(GravityEstimate, ShakingCannotForgeIt) {
  GravityEstimate estimate(kTick);
  estimate.rest({0, 0, kG});
  double most = 0;
  for (int i = 0; i < 2000; ++i) {
    const double shaking = 2 * kG * std::sin(2 * 180 * kDegree * 5 * kTick * i);
    estimate.advance({shaking, 0, kG}, Vector3d::Zero());
    if (i > 1000) most = std::max(most, std::abs(estimate.up().x()));
  }
  EXPECT_LT(most, 0.045 * kG);
  EXPECT_GT(most, 0.03 * kG);
}

// A quick tilt is known at once, as the canals tell it: a quarter turn in a quarter second.
TEST(GravityEstimate, TurnsWithTheHead) {
  GravityEstimate estimate(kTick);
  estimate.rest({0, 0, kG});
  for (int i = 1; i <= 50; ++i) {
    const double angle = 90 * kDegree * i / 50;  // nose down: up goes to the back of the head
    estimate.advance({-kG * std::sin(angle), 0, kG * std::cos(angle)}, {0, 360 * kDegree, 0});
  }
  EXPECT_NEAR(estimate.up().x(), -kG, 0.01);
  EXPECT_NEAR(estimate.up().z(), 0, 0.1);
}

// In the head of 18 months, a sphere of 73.5 mm 10 mm before the ears' axis: 33 mm beside the midline.
TEST(Labyrinth, LiesBetweenTheEars) {
  const Vector3d place = labyrinth_place(true, {0.01, 0, 0.0735}, 0.0735);
  EXPECT_NEAR(place.x(), 0, 1e-12);
  EXPECT_NEAR(place.y(), 0.033, 1e-4);
  EXPECT_NEAR(place.z(), 0.9 * 0.0735, 1e-12);
}

}  // namespace
}  // namespace mimo::receptors
