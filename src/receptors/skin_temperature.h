// How warm skin is: between the blood below it and the air, or what touches it.
#pragma once

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
// The surface of skin that was `before` when something this warm began to touch it `seconds` ago. Touch conducts 350
// W/(m^2 K), fitted to Ho and Jones 2006: copper takes 5 degrees off in 10 s, plastic 2.
double touched_temperature(double before, double other, double other_effusivity, double seconds);

// exp(x^2) erfc(x), for x of 0 or above.
double scaled_erfc(double x);

}  // namespace mimo::receptors
