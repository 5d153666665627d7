// What is heard of a stretch of sound: its spectrum, levels in bands as wide as an ear's, and which ear it reached
// first.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hearing/ears.h"

namespace mimo::hearing {

// The spectrum of a stretch of sound.

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

constexpr std::size_t kBands = 24;
using Levels = std::array<double, kBands>;

// Hz. Evenly spaced on the scale of equivalent rectangular bandwidths (Glasberg and Moore 1990), 100 to 7200 Hz.
Levels band_centres();
// Hz.
double bandwidth(double frequency);

struct Heard {
  std::array<std::array<float, kBands>, kEars> levels{};  // dB above the threshold; 0 below it
  float time_difference = 0;  // s, positive where the left ear is first; 0 where nothing below 1.5 kHz is heard
};

class Bands {
 public:
  // Thresholds in dB of 20 uPa.
  Bands(double rate, const Levels& thresholds);
  // Of kWindow samples of each ear.
  Heard hear(const std::array<std::array<float, kWindow>, kEars>& samples) const;

 private:
  static constexpr std::size_t kLags = 21;          // -10 to 10 samples
  static constexpr std::size_t kLagsInRows = 24;    // whole vectors of a processor; what is beyond the lags is 0
  static constexpr std::size_t kLanes = 8;          // sums of a band, side by side: their order is the same everywhere
  using Power = std::array<float, kBins + kLanes>;  // of each bin, and nothing beyond them

  // Weights of the bins first, first + 1, ... of a spectrum's power.
  struct Band {
    std::size_t first;
    std::vector<float> weights;  // to whole lanes, with zeros
    double threshold;            // dB
    float least;                 // power at the threshold
    bool low;                    // of those whose phases are compared
  };

  static float sum_of(const Band& band, const Power& power);
  float time_difference(const Complexes& left, const Complexes& right) const;

  double rate_;
  std::size_t low_bins_;  // bins below 1.5 kHz
  Transform transform_;
  std::array<float, kWindow> window_;
  std::vector<Band> bands_;
  struct Turns {  // of a bin's phase, by lag
    std::array<float, kLagsInRows> cosines{}, sines{};
  };
  std::vector<Turns> turns_;  // of the bins from 1 on
};

}  // namespace mimo::hearing
