// The spectrum of a stretch of sound.
#pragma once

#include <array>
#include <cstddef>

namespace mimo::hearing {

constexpr std::size_t kWindow = 512;  // samples: 32 ms at 16 kHz
constexpr std::size_t kBins = kWindow / 2;

// Complex numbers with their parts apart, as vectors of a processor want them.
struct Complexes {
  std::array<float, kBins> real, imag;
};

// Discrete Fourier transform of kWindow real numbers as one of half as many complex ones: by quarters (Cooley and Tukey
// 1965), each pass in the order that the next one reads in rows (Stockham).
class Transform {
 public:
  Transform();
  // Without the bin of half the rate.
  Complexes operator()(const std::array<float, kWindow>& samples) const;

 private:
  template <std::size_t kGroup>
  void quarter(const Complexes& from, Complexes& to) const;

  std::array<Complexes, 4> turns_;  // exp(-2 pi i k p / kBins) for k = 0 to 3
  Complexes half_turns_;            // exp(-2 pi i p / kWindow)
};

}  // namespace mimo::hearing
