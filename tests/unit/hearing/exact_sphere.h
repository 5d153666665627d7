// The sound of a point source on a rigid sphere, exactly: the series of Rayleigh as Duda and Martens (1998) sum it.
#pragma once

#include <cmath>
#include <complex>

#include "base/numbers.h"

namespace mimo::hearing {

// Over the pressure in free air at the sphere's middle; with exp(i w t).
inline std::complex<double> exact_sphere(double radius, double distance, double angle, double frequency) {
  using Complex = std::complex<double>;
  const double rho = distance / radius, mu = 2 * kPi * frequency * radius / 343, x = std::cos(angle);
  const Complex i(0, 1), zr = 1.0 / (i * mu * rho), za = 1.0 / (i * mu);
  Complex qr2 = zr, qr1 = zr * (1.0 - zr), qa2 = za, qa1 = za * (1.0 - za);
  double p2 = 1, p1 = x;
  Complex sum = zr / (za * (za - 1.0)) + 3 * x * zr * (zr - 1.0) / (za * (2.0 * za * za - 2.0 * za + 1.0));
  double before = 1;
  for (int m = 2; m < 300; ++m) {
    const Complex qr = -(2.0 * m - 1) * zr * qr1 + qr2, qa = -(2.0 * m - 1) * za * qa1 + qa2;
    const double p = ((2 * m - 1) * x * p1 - (m - 1) * p2) / m;
    const Complex term = (2.0 * m + 1) * p * qr / ((m + 1.0) * za * qa - qa1);
    sum += term;
    const double now = std::abs(term) / std::abs(sum);
    if (now < 1e-9 && before < 1e-9) break;
    before = now;
    qr2 = qr1;
    qr1 = qr;
    qa2 = qa1;
    qa1 = qa;
    p2 = p1;
    p1 = p;
  }
  // Relative to the middle the wave has come this far; the sum's time runs the other way.
  return std::conj(rho * std::exp(-i * mu) * sum / (i * mu) * std::exp(Complex(0, 0)));
}

}  // namespace mimo::hearing
