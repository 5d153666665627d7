#include "hearing/bands.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "sound/air.h"

namespace mimo::hearing {
namespace {

using Complex = std::complex<float>;

constexpr double kLowest = 100, kHighest = 7200;  // Hz
constexpr double kPhaseLimit = 1500;              // Hz, above which the ears' phases are not compared

double band_number(double frequency) { return 21.4 * std::log10(1 + 0.00437 * frequency); }
double frequency_of(double number) { return (std::pow(10, number / 21.4) - 1) / 0.00437; }

// Power of a filter of the inner ear at a distance in hertz: gammatone of fourth order.
double passed(double off, double width) {
  const double x = off / (1.019 * width);
  return std::pow(1 + x * x, -4);
}

// Power of a Hann window's spectrum, so many bins beside its peak, where it is 1.
double leaked(double bins) {
  const auto sinc = [](double x) { return std::abs(x) < 1e-9 ? 1 : std::sin(kPi * x) / (kPi * x); };
  const double amplitude = sinc(bins) + 0.5 * sinc(bins - 1) + 0.5 * sinc(bins + 1);
  return amplitude * amplitude;
}

}  // namespace

Levels band_centres() {
  Levels centres;
  const double first = band_number(kLowest), last = band_number(kHighest);
  for (std::size_t i = 0; i < kBands; ++i) {
    centres[i] = frequency_of(first + (last - first) * static_cast<double>(i) / static_cast<double>(kBands - 1));
  }
  return centres;
}

double bandwidth(double frequency) { return 24.7 * (4.37 * frequency / 1000 + 1); }

Bands::Bands(double rate, const Levels& thresholds) : rate_(rate) {
  const double bin = rate / static_cast<double>(kWindow);
  low_bins_ = std::min(static_cast<std::size_t>(kPhaseLimit / bin), kWindow / 2 - 1);
  for (std::size_t i = 0; i < kWindow; ++i) {
    window_[i] = static_cast<float>(0.5 - 0.5 * std::cos(2 * kPi * static_cast<double>(i) / kWindow));
  }
  // A sine of amplitude A has a peak of A kWindow / 4 in the spectrum of a Hann window, and the mean square A^2 / 2.
  const double peak = kWindow / 4.0;
  const Levels centres = band_centres();
  for (std::size_t band = 0; band < kBands; ++band) {
    const double centre = centres[band], width = bandwidth(centre), reach = 3 * width + 2 * bin;
    const auto first = static_cast<std::size_t>(std::max(1.0, std::ceil((centre - reach) / bin)));
    const auto last = static_cast<std::size_t>(std::min(kWindow / 2 - 1.0, std::floor((centre + reach) / bin)));
    double sum = 0;  // of what a sine in the middle of the band gives
    Band made{first, {}, thresholds[band], centre < kPhaseLimit};
    for (std::size_t i = first; i <= last; ++i) {
      const double off = static_cast<double>(i) * bin - centre, weight = passed(off, width);
      made.weights.push_back(static_cast<float>(weight));
      sum += weight * leaked(off / bin);
    }
    for (float& weight : made.weights) weight *= static_cast<float>(0.5 / (sum * peak * peak));
    bands_.push_back(made);
  }
  for (std::size_t i = 1; i <= low_bins_; ++i) {
    for (std::size_t lag = 0; lag < kLags; ++lag) {
      const double angle = 2 * kPi * static_cast<double>(i) * (static_cast<double>(lag) - (kLags - 1) / 2.0) /
                           static_cast<double>(kWindow);
      turns_.emplace_back(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    }
  }
}

Heard Bands::hear(const std::array<std::array<float, kWindow>, kEars>& samples) const {
  // Both ears in one transform: one is the real part, the other the imaginary one.
  std::array<Complex, kWindow> both;
  for (std::size_t i = 0; i < kWindow; ++i) both[i] = {window_[i] * samples[0][i], window_[i] * samples[1][i]};
  transform_(both);
  Spectrum left, right;
  left[0] = right[0] = 0;
  for (std::size_t i = 1; i < kWindow / 2; ++i) {
    const Complex a = both[i], b = std::conj(both[kWindow - i]);
    left[i] = 0.5F * (a + b);
    right[i] = Complex(0.5F * (a.imag() - b.imag()), -0.5F * (a.real() - b.real()));
  }
  Heard heard;
  bool low = false;
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    const Spectrum& spectrum = ear == 0 ? left : right;
    std::array<float, kWindow / 2> power;
    for (std::size_t i = 0; i < kWindow / 2; ++i) power[i] = std::norm(spectrum[i]);
    for (std::size_t band = 0; band < kBands; ++band) {
      double sum = 0;
      for (std::size_t i = 0; i < bands_[band].weights.size(); ++i) {
        sum += bands_[band].weights[i] * power[bands_[band].first + i];
      }
      if (sum <= 0) continue;
      const double level = 10 * std::log10(sum / (sound::kReference * sound::kReference));
      heard.levels[ear][band] = static_cast<float>(std::max(0.0, level - bands_[band].threshold));
      low = low || (heard.levels[ear][band] > 0 && bands_[band].low);
    }
  }
  if (low) heard.time_difference = time_difference(left, right);
  return heard;
}

// The peak of the ears' cross-correlation, between lags by a parabola.
float Bands::time_difference(const Spectrum& left, const Spectrum& right) const {
  std::array<float, kLags> sums{};
  for (std::size_t i = 1; i <= low_bins_; ++i) {
    const Complex a = left[i], b = right[i];
    // Right times the conjugate of left: its phase falls by as much as the right ear is late.
    const float real = b.real() * a.real() + b.imag() * a.imag(), imag = b.imag() * a.real() - b.real() * a.imag();
    const Complex* turns = turns_.data() + (i - 1) * kLags;
    for (std::size_t lag = 0; lag < kLags; ++lag) sums[lag] += real * turns[lag].real() - imag * turns[lag].imag();
  }
  const auto best = static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
  double at = static_cast<double>(best);
  if (best > 0 && best + 1 < kLags) {
    const float a = sums[best - 1], b = sums[best], c = sums[best + 1], bend = a - 2 * b + c;
    if (bend < 0) at += 0.5 * (a - c) / bend;
  }
  return static_cast<float>((at - (kLags - 1) / 2.0) / rate_);
}

}  // namespace mimo::hearing
