// Functions that give the same bytes with every compiler, C library and processor of docs/platforms.md.
//
// States move between these systems, and worlds go on as if they had stayed. C libraries differ in the last digits of
// sin, exp, pow and the like, and one library does so between processors with and without fused multiplication. Those
// of `fixed` add, multiply, divide and take square roots only, which IEEE 754 defines to the last bit. They compute
// with about 65 bits, so that nearly all results are the nearest number to the exact one. The test abi.symbols refuses
// a library that calls the C library's. Quotients, roots and powers of complex numbers come from the library of each
// compiler; sqrt, fmod and what rounds to integers are exact everywhere.
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <cstring>

namespace mimo {

constexpr double square(double x) { return x * x; }

namespace fixed {

double exp(double x);
double expm1(double x);
double exp2(double x);
double log(double x);
double log1p(double x);
double log2(double x);
double log10(double x);
double pow(double x, double y);
double cbrt(double x);  // of numbers that are not negative

double sin(double x);
double cos(double x);
double tan(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);

double erfc(double x);  // to 1e-20, also where it is small

// exp(x) of numbers from -87 to 0, to two last digits; written so that compilers do many at once.
inline float exp_of_negative(float x) {
  constexpr float kPerLog2 = 1.44269504F, kLog2 = 0.693359375F,
                  kRest = -2.12194440e-4F;  // of kLog2, whose end is zeros
  constexpr float kRounds = 0x1.8p23F;      // has no places for fractions
  const float shifted = x * kPerLog2 + kRounds, twos = shifted - kRounds;
  const float r = x - twos * kLog2 - twos * kRest;
  const float more = 0.5F + r * (1 / 6.0F + r * (1 / 24.0F + r * (1 / 120.0F + r * (1 / 720.0F))));
  const float part = 1 + (r + r * r * more);
  std::uint32_t bits, power;
  std::memcpy(&bits, &shifted, sizeof bits);
  std::memcpy(&power, &part, sizeof power);
  power += bits << 23;  // part times 2 to the twos
  float result;
  std::memcpy(&result, &power, sizeof result);
  return result;
}

}  // namespace fixed

// A quaternion of Eigen's, about an axis of length 1; Eigen's own calls the C library.
template <typename Quaternion, typename Axis>
Quaternion turn_about(const Axis& axis, double angle) {
  const double sine = fixed::sin(0.5 * angle);
  return Quaternion(fixed::cos(0.5 * angle), sine * axis[0], sine * axis[1], sine * axis[2]);
}

inline std::complex<double> quotient(const std::complex<double>& a, const std::complex<double>& b) {
  return a * std::conj(b) / std::norm(b);
}

}  // namespace mimo
