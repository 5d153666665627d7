// Functions that give the same bytes with every compiler, C library and processor of docs/platforms.md.
//
// States move between these systems, and worlds go on as if they had stayed. exp, log, pow, sin, cos, acos and atan2 of
// glibc 2.28 and newer allow that: they compute alike on all processors. cbrt, log1p, exp2 and log10 do not, and
// quotients, square roots and powers of complex numbers come from the library of each compiler.
#pragma once

#include <cmath>
#include <complex>

namespace mimo {

// Of numbers that are not negative.
inline double cube_root(double x) { return std::pow(x, 1.0 / 3); }

// log(1 + x) of numbers that are not negative. What 1 + x loses of a small x is given back as a factor (W. Kahan).
inline double log_of_1_plus(double x) {
  const double sum = 1 + x;
  return sum == 1 ? x : std::log(sum) * (x / (sum - 1));
}

inline double two_to(double x) {
  constexpr double kLogOf2 = 0.69314718055994531;
  return std::exp(x * kLogOf2);
}

inline double log_10(double x) {
  constexpr double kLogOf10 = 2.30258509299404568;
  return std::log(x) / kLogOf10;
}

inline std::complex<double> quotient(const std::complex<double>& a, const std::complex<double>& b) {
  return a * std::conj(b) / std::norm(b);
}

}  // namespace mimo
