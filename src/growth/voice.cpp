#include "growth/voice.h"

#include "growth/points.h"

namespace mimo::growth {
namespace {

// Means of comfort sounds at 3, 6 and 9 months: Kent and Murray 1982. Before and after that they are held.
constexpr Point kPitch[] = {{0, 445}, {3, 445}, {6, 450}, {9, 415}, {24, 415}};

// 7.5 cm at birth is the textbooks' usual value; it grows by 1.5 to 2 cm in two years (Vorperian and Kent 2007).
constexpr Point kLength[] = {{0, 0.075}, {24, 0.095}};
constexpr double kWarmAir = 353;  // speed of sound in it, m/s

}  // namespace

double vocal_pitch(double age) { return on_lines(kPitch, age); }

std::array<double, kFormants> vocal_formants(double age) {
  const double lowest = kWarmAir / (4 * on_lines(kLength, age));
  return {lowest, 3 * lowest, 5 * lowest};
}

}  // namespace mimo::growth
