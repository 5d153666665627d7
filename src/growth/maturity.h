// How eyes, ears, nerves and the voice are at an age.
#pragma once

#include <array>
#include <cstddef>

namespace mimo::growth {

// How long nerves take at an age: the speed of their fibres, and what the way through the brain adds.

struct Conduction {
  double speed = 0;       // of large fibres, sensory and motor, m/s; 0: the way takes no time
  double sensory = 0;     // from the brain stem to the cortex, s
  double motor = 0;       // from the cortex to the brain stem, s
  double vision = 0;      // from the eye to the first signal of the cortex, s
  double vestibular = 0;  // from the inner ear to the brain stem, s
  double hearing = 0;     // from the ear to the cortex, s

  bool any() const {
    return speed != 0 || sensory != 0 || motor != 0 || vision != 0 || vestibular != 0 || hearing != 0;
  }
  // What the way of a nerve of this length takes, s.
  double along(double metres) const { return speed > 0 ? metres / speed : 0; }
};

// At an age in months, 0 to 24.
Conduction conduction_at(double age);

// How well eyes see at an age.

struct EyeMaturity {
  double acuity;         // the finest lines that are seen, cycles per degree
  double peak_contrast;  // greatest contrast sensitivity
  double chroma;         // share of colour that is seen, 0 to 1
  double flicker;        // Hz: where a low-pass in time leaves half the power of a change
};

// At an age in months, 0 to 24.
EyeMaturity eye_maturity_at(double age);

// What an infant hears at an age.

// The weakest tone that infants of an age in months (0 to 24) turn to or show otherwise that they hear: dB of 20 uPa at
// a frequency in hertz, 125 to 8000 and flat beyond.
double hearing_threshold(double age, double frequency);

// What an infant's voice is like at an age in months, 0 to 24.

constexpr std::size_t kFormants = 3;

// Fundamental frequency of its comfort sounds, Hz.
double vocal_pitch(double age);
// Resonances of its vocal tract at rest: a tube that is open at one end. Hz.
std::array<double, kFormants> vocal_formants(double age);

// Numbers that are known at some ages.

struct Point {
  double age, value;  // months
};

// The points' values on both sides of an age, and how far it is from the left one to the right one, 0 to 1.
struct Stretch {
  double left, right, share;
};

// Ages rise; beyond their ends the last value stays.
template <std::size_t kCount>
Stretch stretch_at(const Point (&points)[kCount], double age) {
  if (age <= points[0].age) return {points[0].value, points[0].value, 0};
  for (std::size_t i = 1; i < kCount; ++i) {
    const Point &left = points[i - 1], &right = points[i];
    if (age <= right.age) return {left.value, right.value, (age - left.age) / (right.age - left.age)};
  }
  return {points[kCount - 1].value, points[kCount - 1].value, 0};
}

// On straight lines through the points.
template <std::size_t kCount>
double on_lines(const Point (&points)[kCount], double age) {
  const Stretch at = stretch_at(points, age);
  return at.left + (at.right - at.left) * at.share;
}

}  // namespace mimo::growth
