#include "actuation/muscle_curves.h"

namespace mimo::actuation::curves {
namespace {

constexpr double square(double x) { return x * x; }
constexpr double cube(double x) { return x * x * x; }

// A smooth bump of four parabolas: 0 at and beyond `low` and `high`, 1 at `middle`.
double bump(double x, double low, double middle, double high) {
  if (x <= low || x >= high) return 0;
  const double left = (low + middle) / 2;
  const double right = (middle + high) / 2;
  if (x < left) return square((x - low) / (left - low)) / 2;
  if (x < middle) return 1 - square((middle - x) / (middle - left)) / 2;
  if (x < right) return 1 - square((x - middle) / (right - middle)) / 2;
  return square((high - x) / (high - right)) / 2;
}

}  // namespace

double force_length(double length) {
  constexpr double kShoulder = 0.95;
  return bump(length, kShortest, 1, kLongest) + 0.15 * bump(length, kShortest, (kShortest + kShoulder) / 2, kShoulder);
}

double force_velocity(double velocity) {
  constexpr double kGain = kStretched - 1;
  if (velocity < -1) return 0;
  if (velocity <= 0) return square(velocity + 1);
  if (velocity <= kGain) return kStretched - square(kGain - velocity) / kGain;
  return kStretched;
}

double passive_force(double length) {
  constexpr double kBend = (kLongest + 1) / 2;  // from here on it grows linearly
  constexpr double kScale = 0.25 * kPassive;
  if (length <= 1) return 0;
  if (length <= kBend) return kScale * cube((length - 1) / (kBend - 1));
  return kScale * (1 + 3 * (length - kBend) / (kBend - 1));
}

}  // namespace mimo::actuation::curves
