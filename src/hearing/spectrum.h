// The spectra of two signals at once.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "base/span.h"

namespace mimo::hearing {

constexpr std::size_t kWindow = 512;  // samples: 32 ms at 16 kHz

// Discrete Fourier transform of kWindow complex numbers, by halves (Cooley and Tukey 1965).
class Transform {
 public:
  Transform();
  void operator()(std::array<std::complex<float>, kWindow>& values) const;

 private:
  std::vector<std::complex<float>> turns_;
  std::vector<std::size_t> order_;
};

}  // namespace mimo::hearing
