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
