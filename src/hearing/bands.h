// What is heard of a stretch of sound: levels in bands as wide as those of ears, and which ear it reached first.
#pragma once

#include <array>
#include <vector>

#include "hearing/head.h"
#include "hearing/spectrum.h"

namespace mimo::hearing {

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
  static constexpr std::size_t kLags = 21;  // -10 to 10 samples
  using Spectrum = std::array<std::complex<float>, kWindow / 2>;

  float time_difference(const Spectrum& left, const Spectrum& right) const;

  // Weights of the bins first, first + 1, ... of a spectrum's power.
  struct Band {
    std::size_t first;
    std::vector<float> weights;
    double threshold;
    bool low;  // of those whose phases are compared
  };

  double rate_;
  std::size_t low_bins_;  // bins below 1.5 kHz
  Transform transform_;
  std::array<float, kWindow> window_;
  std::vector<Band> bands_;
  std::vector<std::complex<float>> turns_;  // lags of a bin, bin after bin
};

}  // namespace mimo::hearing
