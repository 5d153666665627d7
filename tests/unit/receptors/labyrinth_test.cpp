// The labyrinth's afferents against the numbers of their sources.
#include "receptors/labyrinth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "base/numbers.h"

namespace mimo::receptors {
namespace {

using Eigen::Vector3d;

constexpr double kTick = 0.005;
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
TEST(Canals, ResponseToALongTurnFades) {
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
TEST(Canals, ReportTheOppositeTurnAtAStop) {
  Canals canals(kTick);
  canals.rest(60 * kDegree * canal_axis(1));
  canals.advance(Vector3d::Zero());
  canals.advance(Vector3d::Zero());
  EXPECT_NEAR(over_rest(canals, 1, Afferent::kRegular), -26.18, 0.03);
}

// Components of the directions of Della Santina et al. 2005: yaw to the left, pitch nose down, roll right side down.
TEST(Canals, ReportTheDirection) {
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

// Amplitude and lead of the answer to a sine of 1 deg/s about a canal.
struct Answer {
  double amplitude, lead;  // spikes/s, degrees
};
Answer canal_answer(double hertz, Afferent type, double tick) {
  Canals canals(tick);
  canals.rest(Vector3d::Zero());
  const double turn = 2 * kPi * hertz;
  const int cycles = hertz < 0.05 ? 3 : 6, each = static_cast<int>(std::lround(1 / hertz / tick));
  double sine = 0, cosine = 0;
  for (int i = 1; i <= cycles * each; ++i) {
    const double at = turn * i * tick;
    canals.advance(std::sin(at) * kDegree * canal_axis(0));
    if (i <= (cycles - 1) * each) continue;
    sine += 2 * over_rest(canals, 0, type) * std::sin(at) / each;
    cosine += 2 * over_rest(canals, 0, type) * std::cos(at) / each;
  }
  return {std::hypot(sine, cosine), std::atan2(cosine, sine) / kDegree};
}

// H(s) = K s (s + 1/T1) / ((s + 1/Tc)(s + 1/T2)) of Schneider et al. 2015.
std::complex<double> schneider(double hertz, Afferent type) {
  const bool regular = type == Afferent::kRegular;
  const double k = regular ? 2.83 : 27.09, t1 = regular ? 0.0175 : 0.030, t2 = regular ? 0.0027 : 0.0006;
  const std::complex<double> s(0, 2 * kPi * hertz);
  return k * s * (s + 1 / t1) / ((s + 1 / 5.7) * (s + 1 / t2));
}

// The formula as the literature's tables have it.
TEST(Canals, HaveTheTransferFunctionOfTheTable) {
  const double known[][3] = {{0.01, 0.147, 70.4}, {0.1, 0.421, 16.1}, {1, 0.439, 6.9}, {5, 0.4965, 24.3}};
  for (const auto& [hertz, gain, lead] : known) {
    EXPECT_NEAR(std::abs(schneider(hertz, Afferent::kRegular)), gain, 6e-4);
    EXPECT_NEAR(std::arg(schneider(hertz, Afferent::kRegular)) / kDegree, lead, 0.1);
  }
  EXPECT_NEAR(std::abs(schneider(5, Afferent::kIrregular)), 0.744, 6e-4);
}

// In steps of 5 ms and shorter within 1 % up to 5 Hz and 2 % at 10 Hz, and within a degree.
TEST(Canals, FollowTheirTransferFunction) {
  for (const Afferent type : {Afferent::kRegular, Afferent::kIrregular}) {
    for (const double tick : {5e-4, 1e-3, 2e-3, 2.5e-3, 5e-3}) {
      for (const double hertz : {0.01, 0.1, 1.0, 2.0, 5.0, 10.0}) {
        const Answer answer = canal_answer(hertz, type, tick);
        const std::complex<double> expected = schneider(hertz, type);
        EXPECT_NEAR(answer.amplitude / std::abs(expected), 1, hertz > 5 ? 0.02 : 0.01) << hertz << " Hz, " << tick;
        EXPECT_NEAR(answer.lead, std::arg(expected) / kDegree, 1) << hertz << " Hz, " << tick;
      }
    }
  }
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
TEST(Maculae, RespondToTiltByItsCosine) {
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
  const double turn = 2 * kPi * hertz;
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

// A first-order lag of 1.54 s lets at most a / (2 pi f 1.54 s) of a shaking of a through: 2 g at 5 Hz 0.041 g.
TEST(GravityEstimate, IgnoresShaking) {
  GravityEstimate estimate(kTick);
  estimate.rest({0, 0, kG});
  double most = 0;
  for (int i = 0; i < 2000; ++i) {
    const double shaking = 2 * kG * std::sin(2 * kPi * 5 * kTick * i);
    estimate.advance({shaking, 0, kG}, Vector3d::Zero());
    if (i > 1000) most = std::max(most, std::abs(estimate.up().x()));
  }
  EXPECT_LT(most, 0.045 * kG);
  EXPECT_GT(most, 0.03 * kG);
}

// How far an estimate is from what is up after a head was turned about y for `seconds`, degrees: each tick of 15 s.
std::vector<double> errors_of(double degrees, double seconds, const Vector3d& axis) {
  Canals canals(kTick);
  GravityEstimate estimate(kTick);
  canals.rest(Vector3d::Zero());
  estimate.rest({0, 0, kG});
  std::vector<double> errors;
  const int turning = static_cast<int>(std::lround(seconds / kTick));
  for (int i = 1; i <= turning + 3000; ++i) {
    const double share = std::min(1.0, static_cast<double>(i) / turning);
    const Vector3d up = Eigen::AngleAxisd(-share * degrees * kDegree, axis) * Vector3d(0, 0, kG);
    canals.advance(i <= turning ? Vector3d(degrees / seconds * kDegree * axis) : Vector3d(0, 0, 0));
    estimate.advance(up, canals.told());
    errors.push_back(std::atan2(up.cross(estimate.up()).norm(), up.dot(estimate.up())) / kDegree);
  }
  return errors;
}

// The same by the equations of Laurens and Angelaki 2011 in a plane, with the constants of Laurens et al. 2013 (time to
// believe 1/0.65 s, leak 14 s, correction 0.38; storage 0.247/s of canals of 4 s), in steps of 10 us.
double expected_error(double degrees, double seconds, double at) {
  constexpr double kFine = 1e-5, kCanal = 5.7;
  std::complex<double> estimate = 1;
  double angle = 0, canal = degrees * kDegree / seconds, stored = 0;
  for (int i = 0; i < std::lround(at / kFine); ++i) {
    const double now = i * kFine;
    if (now < seconds) angle += kFine * degrees * kDegree / seconds;
    if (i == std::lround(seconds / kFine)) canal -= degrees * kDegree / seconds;
    const std::complex<double> felt = std::polar(1.0, angle);
    const double ahead = std::arg(felt / estimate);
    const double store = 0.247 * 4 / kCanal * canal - stored / 14 + 0.38 * std::sin(ahead);
    estimate += kFine * (std::complex<double>(0, canal + stored) * estimate + 0.65 * (felt - estimate));
    stored += kFine * store;
    canal -= kFine * canal / kCanal;
  }
  return std::abs(std::arg(std::polar(1.0, angle) / estimate)) / kDegree;
}

// A quick tilt is known at once and stays known, although the canals tell a turn back for 5.7 s.
TEST(GravityEstimate, FollowsAQuickTiltAndStaysThere) {
  for (const auto& [degrees, seconds] : {std::pair{90.0, 0.2}, {45.0, 0.1}, {-90.0, 0.5}, {170.0, 0.4}}) {
    for (const Vector3d& axis : {Vector3d(0, 1, 0), Vector3d(1, 0, 0), Vector3d(0.6, 0.8, 0)}) {
      const std::vector<double> errors = errors_of(degrees, seconds, axis);
      EXPECT_LT(*std::max_element(errors.begin(), errors.end()), 0.025 * std::abs(degrees)) << degrees;
      for (const double at : {0.3, 0.8, 2.8, 4.0, 9.8}) {
        const auto tick = static_cast<std::size_t>(std::lround((seconds + at) / kTick)) - 1;
        EXPECT_NEAR(errors[tick], expected_error(std::abs(degrees), seconds, seconds + at), 0.1)
            << degrees << " " << at;
      }
      EXPECT_LT(errors.back(), 0.005 * std::abs(degrees));
    }
  }
}

// A head upright that turns about the vertical for a minute, and one that stops then, are upright.
TEST(GravityEstimate, KeepsUprightDuringAnUprightTurn) {
  Canals canals(kTick);
  GravityEstimate estimate(kTick);
  canals.rest(Vector3d::Zero());
  estimate.rest({0, 0, kG});
  for (int i = 0; i < 24000; ++i) {
    canals.advance({0, 0, i < 12000 ? 60 * kDegree : 0});
    estimate.advance({0, 0, kG}, canals.told());
    ASSERT_NEAR(estimate.up().head<2>().norm(), 0, 1e-9);
  }
}

// What lasts longer than two seconds is taken for a tilt: 0.2 g to the front for long is one of atan(0.2) = 11.3
// degrees.
TEST(GravityEstimate, FollowsALastingForce) {
  GravityEstimate estimate(kTick);
  estimate.rest({0, 0, kG});
  for (int i = 0; i < 12000; ++i) estimate.advance({0.2 * kG, 0, kG}, Vector3d::Zero());
  EXPECT_NEAR(std::atan2(estimate.up().x(), estimate.up().z()) / kDegree, 11.31, 0.2);
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
