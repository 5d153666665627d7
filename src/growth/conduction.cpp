#include "growth/conduction.h"

#include <cmath>
#include <cstddef>

#include "growth/points.h"

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
  const double p1 = 104 + 156 / (1 + std::exp((age * kWeeks - 6) / 1.7));
  return kFirstSignal * p1 * kMillisecond;
}

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

}  // namespace mimo::growth
