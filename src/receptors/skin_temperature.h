// How warm skin is: between the blood below it and the air, or what touches it.
#pragma once

#include <cmath>

namespace mimo::receptors {

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

}  // namespace mimo::receptors
