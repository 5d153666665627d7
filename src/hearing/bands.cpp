#include "hearing/bands.h"

#include <algorithm>
#include <cmath>

#include "base/functions.h"
#include "base/numbers.h"
#include "base/span.h"
#include "sound/air.h"

namespace mimo::hearing {
namespace {

constexpr std::size_t kQuarter = kBins / 4;

void set_turn(Complexes& turns, std::size_t at, double part) {
  turns.real[at] = static_cast<float>(fixed::cos(-2 * kPi * part));
  turns.imag[at] = static_cast<float>(fixed::sin(-2 * kPi * part));
}

// A number times a turn, by hand: std::complex would look for infinities.
void put(Complexes& to, std::size_t at, float real, float imag, float cosine, float sine) {
  to.real[at] = cosine * real - sine * imag;
  to.imag[at] = cosine * imag + sine * real;
}

constexpr double kLowest = 100, kHighest = 7200;  // Hz
constexpr double kPhaseLimit = 1500;              // Hz, above which the ears' phases are not compared

double band_number(double frequency) { return 21.4 * fixed::log10(1 + 0.00437 * frequency); }
double frequency_of(double number) { return (fixed::pow(10, number / 21.4) - 1) / 0.00437; }

// Power of a filter of the inner ear at a distance in hertz: gammatone of fourth order.
double passed(double off, double width) {
  const double x = off / (1.019 * width);
  return fixed::pow(1 + x * x, -4);
}

// Power of a Hann window's spectrum, so many bins beside its peak, where it is 1.
double leaked(double bins) {
  const auto sinc = [](double x) { return std::abs(x) < 1e-9 ? 1 : fixed::sin(kPi * x) / (kPi * x); };
  const double amplitude = sinc(bins) + 0.5 * sinc(bins - 1) + 0.5 * sinc(bins + 1);
  return amplitude * amplitude;
}

}  // namespace

Transform::Transform() {
  for (std::size_t i = 0; i < kBins; ++i) {
    for (std::size_t k = 0; k < turns_.size(); ++k) set_turn(turns_[k], i, static_cast<double>(k * i) / kBins);
    set_turn(half_turns_, i, static_cast<double>(i) / kWindow);
  }
}

// Numbers that are turned alike lie in groups, side by side.
template <std::size_t kGroup>
void Transform::quarter(const Complexes& from, Complexes& to) const {
  for (std::size_t first = 0; first < kQuarter; first += kGroup) {
    for (std::size_t i = first; i < first + kGroup; ++i) {
      const float *x = &from.real[i], *y = &from.imag[i];
      const float even_x = x[0] + x[2 * kQuarter], odd_x = x[0] - x[2 * kQuarter];
      const float even_y = y[0] + y[2 * kQuarter], odd_y = y[0] - y[2 * kQuarter];
      const float both_x = x[kQuarter] + x[3 * kQuarter], off_x = x[kQuarter] - x[3 * kQuarter];
      const float both_y = y[kQuarter] + y[3 * kQuarter], off_y = y[kQuarter] - y[3 * kQuarter];
      const std::size_t at = 3 * first + i;
      to.real[at] = even_x + both_x;
      to.imag[at] = even_y + both_y;
      put(to, at + kGroup, odd_x + off_y, odd_y - off_x, turns_[1].real[first], turns_[1].imag[first]);
      put(to, at + 2 * kGroup, even_x - both_x, even_y - both_y, turns_[2].real[first], turns_[2].imag[first]);
      put(to, at + 3 * kGroup, odd_x - off_y, odd_y + off_x, turns_[3].real[first], turns_[3].imag[first]);
    }
  }
}

Complexes Transform::operator()(const std::array<float, kWindow>& samples) const {
  Complexes one, other;
  for (std::size_t i = 0; i < kBins; ++i) {
    one.real[i] = samples[2 * i];
    one.imag[i] = samples[2 * i + 1];
  }
  quarter<1>(one, other);
  quarter<4>(other, one);
  quarter<16>(one, other);
  quarter<64>(other, one);
  // Even samples were real parts, odd ones imaginary: their spectra come apart by symmetry.
  other.real[0] = one.real[0] + one.imag[0];
  other.imag[0] = 0;
  for (std::size_t i = 1; i < kBins; ++i) {
    const std::size_t mirrored = kBins - i;
    const float even_x = one.real[i] + one.real[mirrored], even_y = one.imag[i] - one.imag[mirrored];
    const float odd_x = one.imag[i] + one.imag[mirrored], odd_y = one.real[mirrored] - one.real[i];
    put(other, i, odd_x, odd_y, half_turns_.real[i], half_turns_.imag[i]);
    other.real[i] = 0.5F * (even_x + other.real[i]);
    other.imag[i] = 0.5F * (even_y + other.imag[i]);
  }
  return other;
}

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
  low_bins_ = std::min(static_cast<std::size_t>(kPhaseLimit / bin), kBins - 1);
  for (std::size_t i = 0; i < kWindow; ++i) {
    window_[i] = static_cast<float>(0.5 - 0.5 * fixed::cos(2 * kPi * static_cast<double>(i) / kWindow));
  }
  // A sine of amplitude A has a peak of A kWindow / 4 in the spectrum of a Hann window, and the mean square A^2 / 2.
  const double peak = kWindow / 4.0;
  const Levels centres = band_centres();
  for (std::size_t band = 0; band < kBands; ++band) {
    const double centre = centres[band], width = bandwidth(centre), reach = 3 * width + 2 * bin;
    const auto first = static_cast<std::size_t>(std::max(1.0, std::ceil((centre - reach) / bin)));
    const auto last = static_cast<std::size_t>(std::min(kBins - 1.0, std::floor((centre + reach) / bin)));
    double sum = 0;  // of what a sine in the middle of the band gives
    const double least = sound::kReference * sound::kReference * fixed::pow(10, thresholds[band] / 10);
    Band made{first, {}, thresholds[band], static_cast<float>(least), centre < kPhaseLimit};
    for (std::size_t i = first; i <= last; ++i) {
      const double off = static_cast<double>(i) * bin - centre, weight = passed(off, width);
      made.weights.push_back(static_cast<float>(weight));
      sum += weight * leaked(off / bin);
    }
    for (float& weight : made.weights) weight *= static_cast<float>(0.5 / (sum * peak * peak));
    made.weights.resize((made.weights.size() + kLanes - 1) / kLanes * kLanes);
    bands_.push_back(made);
  }
  for (std::size_t i = 1; i <= low_bins_; ++i) {
    Turns turns;
    for (std::size_t lag = 0; lag < kLags; ++lag) {
      const double angle = 2 * kPi * static_cast<double>(i) * (static_cast<double>(lag) - (kLags - 1) / 2.0) /
                           static_cast<double>(kWindow);
      turns.cosines[lag] = static_cast<float>(fixed::cos(angle));
      turns.sines[lag] = static_cast<float>(fixed::sin(angle));
    }
    turns_.push_back(turns);
  }
}

float Bands::sum_of(const Band& band, const Power& power) {
  std::array<float, kLanes> lanes{};
  for (std::size_t i = 0; i < band.weights.size(); i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      lanes[lane] += band.weights[i + lane] * power[band.first + i + lane];
    }
  }
  return ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
}

Heard Bands::hear(const std::array<std::array<float, kWindow>, kEars>& samples) const {
  Heard heard;
  std::array<Complexes, kEars> spectra;
  bool low = false;
  for (std::size_t ear = 0; ear < kEars; ++ear) {
    std::array<float, kWindow> windowed;
    for (std::size_t i = 0; i < kWindow; ++i) windowed[i] = window_[i] * samples[ear][i];
    spectra[ear] = transform_(windowed);
    const Complexes& spectrum = spectra[ear];
    Power power{};
    for (std::size_t i = 0; i < kBins; ++i) {
      power[i] = spectrum.real[i] * spectrum.real[i] + spectrum.imag[i] * spectrum.imag[i];
    }
    for (std::size_t band = 0; band < kBands; ++band) {
      const float sum = sum_of(bands_[band], power);
      if (!(sum > bands_[band].least)) continue;
      const double level = 10 * fixed::log10(static_cast<double>(sum) / (sound::kReference * sound::kReference));
      heard.levels[ear][band] = static_cast<float>(std::max(0.0, level - bands_[band].threshold));
      low = low || (heard.levels[ear][band] > 0 && bands_[band].low);
    }
  }
  if (low) heard.time_difference = time_difference(spectra[0], spectra[1]);
  return heard;
}

// The peak of the ears' cross-correlation, between lags by a parabola.
float Bands::time_difference(const Complexes& left, const Complexes& right) const {
  std::array<float, kLagsInRows> in_rows{};
  for (std::size_t i = 1; i <= low_bins_; ++i) {
    // Right times the conjugate of left: its phase falls by as much as the right ear is late.
    const float real = right.real[i] * left.real[i] + right.imag[i] * left.imag[i];
    const float imag = right.imag[i] * left.real[i] - right.real[i] * left.imag[i];
    const Turns& turns = turns_[i - 1];
    for (std::size_t lag = 0; lag < kLagsInRows; ++lag) {
      in_rows[lag] += real * turns.cosines[lag] - imag * turns.sines[lag];
    }
  }
  const Span<const float> sums(in_rows.data(), kLags);
  const auto best = static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
  double at = static_cast<double>(best);
  if (best > 0 && best + 1 < kLags) {
    const float a = sums[best - 1], b = sums[best], c = sums[best + 1], bend = a - 2 * b + c;
    if (bend < 0) at += 0.5 * (a - c) / bend;
  }
  return static_cast<float>((at - (kLags - 1) / 2.0) / rate_);
}

}  // namespace mimo::hearing
