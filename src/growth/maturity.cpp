#include "growth/maturity.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "base/functions.h"

namespace mimo::growth {
namespace {

// m/s. One curve through measured medians of motor and sensory nerves of arms and legs (textbook tables up to 6 months;
// Parano 1993 and Garcia 2000 later). A fit: single nerves lie within some 12 % of it.
constexpr Point kSpeed[] = {{0, 24.5}, {1, 26}, {2, 32}, {5, 38}, {9, 43}, {18, 49}, {24, 51}};

// ms. Fitted to the median nerve's evoked potentials of newborns, and of infants of 6 months.
constexpr Point kSensory[] = {{0, 26}, {2, 16}, {6, 10.5}, {12, 8.5}, {24, 7}};

// ms. Weak: infants' central motor times were not found; estimated to fall as the sensory ones, to adult values at ten.
constexpr Point kMotor[] = {{0, 22}, {3, 16}, {6, 13}, {12, 11}, {24, 10}};

// ms. Estimated: nerve and brain stem.
constexpr Point kVestibular[] = {{0, 5}, {24, 3}};

// ms. Estimated.
constexpr Point kHearing[] = {{0, 30}, {6, 20}, {18, 15}, {24, 15}};

constexpr double kMillisecond = 1e-3;

// The first signal arrives well before the wave that is measured, P1 of pattern-reversal potentials: 260 ms in
// newborns, adult from 15 weeks on (McCulloch 1999, Lee 2012). The share is estimated.
double vision(double age) {
  constexpr double kWeeks = 30.4375 / 7, kFirstSignal = 0.6;  // weeks of a month; share of P1
  const double p1 = 104 + 156 / (1 + fixed::exp((age * kWeeks - 6) / 1.7));
  return kFirstSignal * p1 * kMillisecond;
}

// Straight lines through the points' logarithms.
template <std::size_t kCount>
double between(const Point (&points)[kCount], double age) {
  const Stretch at = stretch_at(points, age);
  return at.left * fixed::pow(at.right / at.left, at.share);
}

// Cycles per degree, of one eye. Gratings on cards: at birth Brown and Yamamoto 1986; then the mean of Mayer et al.
// 1995, Salomao and Ventura 1995 and Teller's, weighted by their infants. Individuals lie within 0.45 octaves of it.
constexpr Point kAcuity[] = {{0, 0.70}, {1, 0.88}, {1.5, 1.11}, {2.5, 2.16}, {4, 3.09},
                             {6, 6.01}, {9, 6.52}, {12, 7.47},  {18, 8.97},  {24, 11.1}};

// Estimated between what is known: 2 at birth (Brown 2015), ten times that in a year (Teller 1997), 200 at ten years.
constexpr Point kPeakContrast[] = {{0, 2}, {1, 2.8}, {2, 5}, {3, 8}, {4, 11}, {6, 14}, {9, 17}, {12, 20}, {24, 40}};

// Estimated, from what of flicker infants of 2 to 4 months see best (Rasengane et al. 1997).
constexpr Point kFlicker[] = {{2, 4}, {4, 8}, {12, 15}};

constexpr std::size_t kFrequencies = 7;  // octaves from 125 Hz on
constexpr double kLowest = 125;

// Of adults (ISO 226:2003), dB of 20 uPa: at the octaves, and at the middles of the bands that are heard.
struct Threshold {
  double frequency, level;
};
constexpr Threshold kAdult[] = {
    {100, 26.5},    {125, 22.1},    {147.7, 19.3},  {202.4, 14.2}, {250, 11.4},    {265, 10.7},    {336.7, 7.9},
    {418.8, 5.8},   {500, 4.4},     {512.8, 4.2},   {620.4, 3.1},  {743.7, 2.4},   {884.9, 2.3},   {1000, 2.4},
    {1046.6, 2.6},  {1231.7, 3.4},  {1443.7, 2.4},  {1686.5, 1.0}, {1964.6, -1.1}, {2000, -1.3},   {2283, -3.0},
    {2647.6, -4.6}, {3065.1, -5.8}, {3543.3, -5.7}, {4000, -5.4},  {4090.8, -5.0}, {4717.9, -2.5}, {5436, 1.2},
    {6258.3, 5.8},  {7200, 9.7},    {8000, 12.6}};

// By how much infants' are higher, dB. Anchors are Sinnott 1983 (newborns at 500 and 4000 Hz), Olsho 1988 (3 months at
// 1 and 8 kHz), Nozza and Wilson 1984 and Parry (6 and 12 months); what lies between them is an estimate, and so is all
// at 24 months. Behaviour includes attention: the ears themselves are better than this, most of all those of newborns.
constexpr Point kAbove[kFrequencies][5] = {
    {{0, 48}, {3, 24}, {6, 16}, {12, 16}, {24, 14}}, {{0, 47}, {3, 22}, {6, 15}, {12, 15}, {24, 12}},
    {{0, 45}, {3, 18}, {6, 15}, {12, 14}, {24, 10}}, {{0, 40}, {3, 16}, {6, 14}, {12, 12}, {24, 8}},
    {{0, 36}, {3, 17}, {6, 11}, {12, 8}, {24, 6}},   {{0, 32}, {3, 20}, {6, 8}, {12, 6}, {24, 4}},
    {{0, 40}, {3, 30}, {6, 10}, {12, 8}, {24, 4}},
};

double above_adult(double age, std::size_t octave) {
  const Stretch at = stretch_at(kAbove[octave], age);
  return at.left + (at.right - at.left) * at.share;
}

// Straight lines over the logarithm of frequency; the first and last value beyond.
double adult(double frequency) {
  const auto lower = [](double f, const Threshold& point) { return f < point.frequency; };
  const auto right = std::upper_bound(std::begin(kAdult), std::end(kAdult), frequency, lower);
  if (right == std::begin(kAdult)) return right->level;
  const auto left = right - 1;
  if (right == std::end(kAdult)) return left->level;
  const double share = fixed::log(frequency / left->frequency) / fixed::log(right->frequency / left->frequency);
  return left->level + share * (right->level - left->level);
}

// Means of comfort sounds at 3, 6 and 9 months: Kent and Murray 1982. Before and after that they are held.
constexpr Point kPitch[] = {{0, 445}, {3, 445}, {6, 450}, {9, 415}, {24, 415}};

// 7.5 cm at birth is the textbooks' usual value; it grows by 1.5 to 2 cm in two years (Vorperian and Kent 2007).
constexpr Point kLength[] = {{0, 0.075}, {24, 0.095}};
constexpr double kWarmAir = 353;  // speed of sound in it, m/s

}  // namespace

Conduction conduction_at(double age) {
  Conduction at;
  at.speed = on_lines(kSpeed, age);
  at.sensory = on_lines(kSensory, age) * kMillisecond;
  at.motor = on_lines(kMotor, age) * kMillisecond;
  at.vision = vision(age);
  at.vestibular = on_lines(kVestibular, age) * kMillisecond;
  at.hearing = on_lines(kHearing, age) * kMillisecond;
  return at;
}

// Colour comes in from the first to the third month (Varner 1985, Suttle 1997); the line between is estimated.
EyeMaturity eye_maturity_at(double age) {
  return {between(kAcuity, age), between(kPeakContrast, age), std::clamp((age - 1) / 2, 0.0, 1.0),
          between(kFlicker, age)};
}

double hearing_threshold(double age, double frequency) {
  const double octave = std::clamp(fixed::log2(frequency / kLowest), 0.0, kFrequencies - 1.0);
  const std::size_t below = std::min(static_cast<std::size_t>(octave), kFrequencies - 2);
  const double share = octave - static_cast<double>(below);
  return adult(frequency) + (1 - share) * above_adult(age, below) + share * above_adult(age, below + 1);
}

double vocal_pitch(double age) { return on_lines(kPitch, age); }

std::array<double, kFormants> vocal_formants(double age) {
  const double lowest = kWarmAir / (4 * on_lines(kLength, age));
  return {lowest, 3 * lowest, 5 * lowest};
}

}  // namespace mimo::growth
