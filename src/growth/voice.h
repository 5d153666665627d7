// What an infant's voice is like at an age in months, 0 to 24.
#pragma once

#include <array>
#include <cstddef>

namespace mimo::growth {

constexpr std::size_t kFormants = 3;

// Fundamental frequency of its comfort sounds, Hz.
double vocal_pitch(double age);
// Resonances of its vocal tract at rest: a tube that is open at one end. Hz.
std::array<double, kFormants> vocal_formants(double age);

}  // namespace mimo::growth
