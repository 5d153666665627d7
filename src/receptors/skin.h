// The receptors of the skin: how many there are, and how touch, temperature and damage make them fire.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/functions.h"

namespace mimo::receptors {

// How many afferents a piece of skin has, and how sensitive its region is.

enum class Region { kFace, kEye, kHand, kFinger, kFoot, kTrunk, kArm, kThigh, kLeg };

// In the order of the outputs: SA1, RA, PC, SA2.
constexpr std::size_t kTouchKinds = 4;

// Afferents of a kind per square metre, of adults: 241 per cm^2 at a fingertip, 58 in the palm (Johansson and Vallbo
// 1979), 9 on the trunk (Corniani and Saal 2020); elsewhere 241 (2 mm / two-point distance)^1.2, an estimate that meets
// these three within 8 %. How they divide among the kinds is an estimate, too. Hairy skin has no PC here; fingers have
// no SA2 (Pare 2003 found next to none).
double afferents_per_square_metre(Region region, std::size_t kind);
// A kind's share of all there.
double share_of(Region region, std::size_t kind);

// What shares a number of afferents, both sides of the body together.
enum class Territory { kFace, kEyes, kHands, kFeet, kTrunk, kArms, kThighs, kLegs };
Territory territory_of(Region region);  // a finger is part of the hand

// How many afferents a person has there, of all kinds and at any age: skin grows, and they move apart (Peters and
// Goldreich 2013). 15 % of 230 000 are in the palms of both hands, 19 % in face and lips (Corniani and Saal 2020). The
// rest of an adult's 1.8 m^2, divided by the chart of Lund and Browder (1944, from memory), has 153 360 at the
// densities above. An eye has as many as the face has on the 2 cm^2 that lids leave open, an estimate. All add up to
// 231 664.
double afferents_of(Territory territory);

// Factors of the rates of cold and warm receptors, estimates.
double thermal_factor(Region region);
// Factor of the threshold of pain by pressure, an estimate.
double pain_factor(Region region);

// The four kinds of touch afferents of a patch of skin: SA1 tells how deep it is pressed, RA how fast that changes, PC
// how it is jolted, SA2 how it is stretched. Rates are means of the afferents there.
//
// Rates of SA1, RA and PC are fitted to TouchSim (Saal, Delhaye, Rayhaun and Bensmaia 2017, PNAS 114:E5693), a model of
// monkey and human afferents of the fingertip; SA2, and how deep a force presses, are estimates.

constexpr double kMillimetre = 1e-3;

// Numbers are doubles, or Eigen's arrays of them: many are worked out at each step.

// How deep skin gives way to a force, m: it stiffens. `spacing` is that of the patches, m: a wider one carries more.
template <typename Number>
Number indentation(const Number& force, const Number& spacing) {
  using std::abs;
  const Number pressing = 0.5 * (force + abs(force));  // 0 where it pulls
  return 3 * kMillimetre * pressing / (pressing + 300 * spacing);
}
// How far it is pulled aside.
inline double stretch(double force, double spacing) { return 3 * kMillimetre * force / (force + 150 * spacing); }

// Depth in m, its rate in m/s, and the rate's change in m/s^2. Hz.
double sa1_rate(double depth, double speed);
double ra_rate(double speed);
// TouchSim gives 1.8 spikes for a press and a release at 20 mm/s, which set the 56 Hz for skin whose jolts are those of
// a first-order filter of 10 ms.
template <typename Number>
Number pc_rate(const Number& acceleration) {
  const Number square = acceleration * acceleration;
  return 56 * square / (1 + square);
}
// Of one of two perpendicular directions: stretch along it of `all`, m.
double sa2_rate(double along, double all);

// What slides: ridges `wavelength` apart and `amplitude` high, m.
struct Texture {
  double wavelength, amplitude;
};
// What sliding over a texture adds, Hz: one spike for each ridge that an afferent feels.
double ra_of_sliding(double speed, const Texture& texture);
double pc_of_sliding(double speed, const Texture& texture);

// Below this, in Hz, a dying envelope counts as silence.
constexpr double kSilent = 1;

// How warm skin is: between the blood below it and the air, or what touches it.

// sqrt(conductivity x density x heat capacity) of living skin, W s^0.5 / (m^2 K): J Appl Physiol 1957;11:211.
constexpr double kSkinEffusivity = 1565;

// In W/(m^2 K). Blood and tissue are chosen so that naked skin is 33.0 degrees in a room of 24; both are estimates.
struct Surroundings {
  double core = 37, air = 24;  // degrees Celsius
  double loss = 9.5;           // to still air, naked; 4 under one layer of cotton, 2 under two
  double blood = 21.4;
};

// Of skin that nothing touches.
double resting_temperature(const Surroundings& around);
// What is left of a deviation from it after some seconds.
double skin_kept(const Surroundings& around, double seconds);

// Where two half-spaces meet that were this warm: degrees.
double interface_temperature(double skin, double other, double other_effusivity);

// Numbers are doubles, or Eigen's arrays of them: many are worked out at each step.

// exp(x^2) erfc(x), for x of 0 or above, right to 3e-8: a polynomial over 1 + 2 x, as Shepherd and Laframboise (1981)
// have it, but shorter.
template <typename Number>
Number scaled_erfc(const Number& x) {
  constexpr double kMiddle = 2.75;
  constexpr double kFit[] = {1.258803626,    -0.1304624103, -0.07130588702,  0.1449048623,
                             -0.1144996502,  0.05232801051, -0.01046337301,  -0.002642209245,
                             0.001845067989, 6.13247202e-5, -0.0001902249721};
  const Number at = (x - kMiddle) / (x + kMiddle);
  Number sum = kFit[9] + at * kFit[10];
  for (int i = 8; i >= 0; --i) sum = kFit[i] + at * sum;
  return sum / (1 + 2 * x);
}

// Skin that something touches, from then on. Touch conducts 350 W/(m^2 K), fitted to Ho and Jones 2006: copper takes 5
// degrees off in 10 s, plastic 2.
template <typename Number>
struct TouchingOf {
  Number before;  // degrees, the surface when it began
  Number swing;   // how much warmer it is where they meet
  Number pace;    // s^-0.5, how fast it gets there
};
using Touching = TouchingOf<double>;
// By something this warm; nothing flows to what has no effusivity.
Touching touching(double before, double other, double other_effusivity);
template <typename Number>
Number touched_temperature(const TouchingOf<Number>& by, const Number& seconds) {
  using std::sqrt;
  return by.before + by.swing * (1 - scaled_erfc<Number>(by.pace * sqrt(seconds)));
}

// Cold and warm receptors: how warm skin is where they sit, and how that changes.
//
// Static rates follow fibres of monkeys (Hensel and Iggo 1971): cold ones fire most at 30 degrees, warm ones at 41. The
// curves' widths and the answers to change are estimates; infants are not known.

// How fast they follow the surface: cold receptors lie 0.15 mm deep, warm ones 0.3 mm. s.
constexpr double kColdLag = 0.36, kWarmLag = 1.44;

// Many are worked out for each look, so that they come in eights; seven digits are enough.
using Eight = Eigen::Array<float, 8, 1>;

// Temperature at the receptors, and its change in degrees a second. Hz.
Eight cold_rates(const Eight& temperature, const Eight& change);
Eight warm_rates(const Eight& temperature, const Eight& change);

// Nociceptors: fast ones (A-delta) tell at once and adapt, slow ones (C) go on. Pressure, heat and cold.
//
// The threshold of pressure is that of children's pain (Nikolajsen 2011: 180 kPa at 4 to 12 years), times 0.8 for
// infants, an estimate; thresholds of heat and cold are those of adult fibres. Slopes are estimates.

// Pa, of infants.
constexpr double kPainfulPressure = 0.8 * 180e3;

// Mean pressure in Pa where something with this radius of curvature (m, of both surfaces together) presses on soft
// tissue: Hertz, with 0.2 MPa.
double contact_pressure(double force, double radius);

// Degrees Celsius beyond which slow ones fire.
constexpr double kPainfulHeat = 43, kPainfulCold = 18;

// `over` is the pressure in units of the threshold, `adapted` 0 where it has just been crossed, 1 after long. Hz.
inline double fast_pressure_rate(double over, double adapted) {
  return 20 * std::max(0.0, over - 1) * (1 - 0.6 * adapted);
}
inline double slow_pressure_rate(double over) { return 5 * std::max(0.0, over - 0.8); }
// Of the skin's temperature in degrees Celsius. Hz.
inline double fast_heat_rate(double temperature) { return 5 * std::max(0.0, temperature - 46); }
inline double slow_heat_rate(double temperature) {  // and of cold
  return 2 * std::max(0.0, temperature - kPainfulHeat) + std::max(0.0, kPainfulCold - temperature);
}

constexpr double kFastMost = 100, kSlowMost = 20;  // Hz
constexpr double kFastAdapts = 1;                  // s

// Speeds of their nerves, m/s: adults', the fast ones' share of what large fibres conduct at.
constexpr double kFastShare = 13.0 / 56, kSlowSpeed = 0.8;

// C-tactile afferents, of hairy skin: how it is stroked.
//
// Strokes of 1 to 10 cm/s excite them most (Loken 2009), and skin of 32 degrees: at 18 they fire 35 % less, at 42 47 %
// less (Ackerley 2018). They never exceed 100 impulses a second, and tire for long (Vallbo 2016). How fast they fire
// when fresh, how that falls with the speed, how they tire and recover are estimates.

constexpr double kCtSpeed = 1;  // of their nerves, m/s

// Of fresh ones, for a stroke in m/s on skin of some degrees. Hz.
inline double ct_drive(double speed, double temperature) {
  constexpr double kMost = 50, kBestSpeed = 0.03, kCurvature = 0.6, kBestTemperature = 32;
  constexpr double kWidthBelow = 21.33, kWidthAbove = 12.55;  // 0.65 at 18 degrees, 0.53 at 42
  const double decades = fixed::log10(speed / kBestSpeed), off = temperature - kBestTemperature;
  const double share = off / (off < 0 ? kWidthBelow : kWidthAbove);
  return kMost * std::max(0.0, 1 - kCurvature * decades * decades) * fixed::exp(-share * share);
}

// How tired they are, 0 to 1, some seconds later: each impulse takes a share of what is fresh, which comes back slowly.
inline double ct_fatigue(double before, double drive, double seconds) {
  constexpr double kShare = 0.003, kRecovers = 20;  // of an impulse, s
  const double pace = kShare * drive + 1 / kRecovers, end = kShare * drive / pace;
  return end + (before - end) * fixed::exp(-pace * seconds);
}

}  // namespace mimo::receptors
