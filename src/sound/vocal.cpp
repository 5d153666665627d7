#include "sound/vocal.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "sound/air.h"

namespace mimo::sound {
namespace {

constexpr double kMuscles = 0.02;  // s that they need to follow: an estimate
constexpr double kHighest = 0.45;  // of the rate: where a formant can be
constexpr double kJitter = 0.017;  // of a period, to both sides at most: a deviation of 1 %
constexpr double kFaintest = 1e-3;
constexpr std::array<double, kFormants> kWidths = {100, 150, 250};  // Hz: estimates

// What a jump of a sawtooth is short of when nothing above half the rate is wanted (two samples, a polynomial).
double rounding(double phase, double step) {
  if (phase < step) {
    const double t = phase / step;
    return 2 * t - t * t - 1;
  }
  if (phase > 1 - step) {
    const double t = (phase - 1) / step;
    return t * t + 2 * t + 1;
  }
  return 0;
}

}  // namespace

Vocal::Vocal(double pitch, const std::array<double, kFormants>& formants, double rate, std::size_t samples,
             std::uint64_t number)
    : pitch_(pitch),
      formants_(formants),
      rate_(rate),
      approach_(1 - fixed::exp(-static_cast<double>(samples) / (rate * kMuscles))),
      number_(number) {}

void Vocal::rest() {
  now_ = {};
  amplitude_ = phase_ = 0;
  cycle_ = 0;
  memory_.fill(0);
}

bool Vocal::silent() const {
  return amplitude_ == 0 && std::all_of(memory_.begin(), memory_.end(), [](double value) { return value == 0; });
}

// The articulators move to their targets before phonation starts.
void Vocal::move(const Utterance& told) {
  if (silent()) now_ = {0, told.pitch, told.opening, told.front};
  now_.loudness += approach_ * (told.loudness - now_.loudness);
  now_.pitch += approach_ * (told.pitch - now_.pitch);
  now_.opening += approach_ * (told.opening - now_.opening);
  now_.front += approach_ * (told.front - now_.front);
  if (told.loudness == 0 && now_.loudness < kFaintest) now_.loudness = 0;
}

std::array<Vocal::Resonator, kFormants> Vocal::resonators() const {
  const std::array<double, kFormants> moved = {formants_[0] * now_.opening, formants_[1] * now_.front, formants_[2]};
  std::array<Resonator, kFormants> made;
  for (std::size_t i = 0; i < kFormants; ++i) {
    const double frequency = std::min(moved[i], kHighest * rate_);
    const double far = -fixed::exp(-2 * kPi * kWidths[i] / rate_);
    const double near = 2 * fixed::exp(-kPi * kWidths[i] / rate_) * fixed::cos(2 * kPi * frequency / rate_);
    made[i] = {1 - near - far, near, far};
  }
  return made;
}

// Of a sawtooth from -1 to 1, whose overtones are 2/(pi k): the root of the mean square behind the tube.
double Vocal::loudness_of_one(const std::array<Resonator, kFormants>& tract, double pitch) const {
  double sum = 0;
  for (int k = 1; k * pitch < rate_ / 2; ++k) {
    const double angle = 2 * kPi * k * pitch / rate_, c1 = fixed::cos(angle), s1 = fixed::sin(angle);
    const double c2 = c1 * c1 - s1 * s1, s2 = 2 * s1 * c1;
    double power = 2 / (kPi * kPi * k * k);
    for (const Resonator& one : tract) {
      const double real = 1 - one.near * c1 - one.far * c2, imaginary = one.near * s1 + one.far * s2;
      power *= one.gain * one.gain / (real * real + imaginary * imaginary);
    }
    sum += power;
  }
  return std::sqrt(sum);
}

// The folds' next sample. Of their spectrum, which falls by 12 dB an octave, the mouth's opening gives back 6.
double Vocal::fold(double step) {
  const double jittered = step * (1 + kJitter * scattered(number_, cycle_));
  const double value = 2 * phase_ - 1 - rounding(phase_, jittered);
  phase_ += jittered;
  if (phase_ >= 1) {
    phase_ -= 1;
    ++cycle_;
  }
  return value;
}

bool Vocal::utter(const Utterance& told, Span<float> out) {
  if (silent() && told.loudness == 0) return false;
  move(told);
  const std::array<Resonator, kFormants> tract = resonators();
  const double pitch = pitch_ * fixed::exp2(now_.pitch);
  const double wanted = kCry * now_.loudness * now_.loudness / loudness_of_one(tract, pitch);
  const double slope = (wanted - amplitude_) / static_cast<double>(out.size()), step = pitch / rate_;
  for (std::size_t i = 0; i < out.size(); ++i) {
    double value = (amplitude_ + slope * static_cast<double>(i + 1)) * fold(step);
    for (std::size_t k = 0; k < kFormants; ++k) {
      double &last = memory_[2 * k], &before = memory_[2 * k + 1];
      value = tract[k].gain * value + tract[k].near * last + tract[k].far * before;
      if (std::abs(value) < static_cast<double>(kNothing)) value = 0;
      before = last;
      last = value;
    }
    out[i] = static_cast<float>(value);
  }
  amplitude_ = wanted;
  return true;
}

template <typename Self, typename Visit>
void Vocal::visit(Self& self, Visit&& visit) {
  visit(self.now_.loudness);
  visit(self.now_.pitch);
  visit(self.now_.opening);
  visit(self.now_.front);
  visit(self.amplitude_);
  visit(self.phase_);
  for (auto& number : self.memory_) visit(number);
}

void Vocal::save(ByteWriter& to) const {
  to.put(cycle_);
  visit(*this, [&](double number) { to.put(number); });
}

void Vocal::load(ByteReader& from) {
  cycle_ = from.take<std::uint64_t>();
  visit(*this, [&](double& number) { number = from.take_finite("a voice"); });
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  bool sane = within(now_.loudness, 0, 1) && within(now_.pitch, -0.5, 0.5) && within(now_.opening, 0.69, 1.31) &&
              within(now_.front, 0.69, 1.31) && within(amplitude_, 0, 1e6) && within(phase_, 0, 1);
  for (const double value : memory_) sane = sane && std::abs(value) < 1e6;
  require(sane, "the state holds a voice whose numbers are out of range");
}

}  // namespace mimo::sound
