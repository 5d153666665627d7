// What all sounds have in common: the air that carries them, and noise without a memory.
#pragma once

#include <cstdint>

namespace mimo::sound {

// What carries sound.

constexpr double kSpeed = 343;         // m/s, at 20 degrees Celsius
constexpr double kAirDensity = 1.2;    // kg/m^3
constexpr double kReference = 20e-6;   // Pa, of 0 dB
constexpr double kNominalRate = 16e3;  // samples a second, where the physics step allows
// Filters' memories below this are none: decays must not end in subnormal numbers, which are slow.
constexpr float kNothing = 1e-20F;

// Noise without a memory: a number for each place of a sequence.

// From -1 to 1, evenly, with nothing in common between neighbours (SplitMix64's mixing).
inline double scattered(std::uint64_t sequence, std::uint64_t place) {
  std::uint64_t z = place * 0x9e3779b97f4a7c15u + sequence * 0xd1342543de82ef95u + 0x632be59bd9b4e019u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1.0p-52 - 1;
}

}  // namespace mimo::sound
