// What carries sound.
#pragma once

namespace mimo::sound {

constexpr double kSpeed = 343;         // m/s, at 20 degrees Celsius
constexpr double kAirDensity = 1.2;    // kg/m^3
constexpr double kReference = 20e-6;   // Pa, of 0 dB
constexpr double kNominalRate = 16e3;  // samples a second, where the physics step allows
// Filters' memories below this are none: decays must not end in subnormal numbers, which are slow.
constexpr float kNothing = 1e-20F;

}  // namespace mimo::sound
