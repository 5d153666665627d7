#include "observation/limited_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fail.h"
#include "base/noise.h"

namespace mimo::observation {
namespace {

bool is_picture(const Field& field) { return field.type == Type::kU8 && field.shape.size() == 3; }

std::vector<double> delays_of(const Limits& limits, const Nature& nature) {
  return limits.delay > 0 ? std::vector<double>{limits.delay} : nature.delays;
}

// The limit of blur leaves half the contrast.
Eyesight blurred(double cycles) { return {cycles, 2, 1}; }

std::optional<EyeFilter> eye_of(const Field& field, const Limits& limits, const Eyesight& eyes) {
  if (limits.blur > 0) {
    require(is_picture(field) && field.pixels_per_degree > 0, "blur is {}, but {} is no picture in colour", limits.blur,
            field.name);
  }
  if (!is_picture(field) || field.pixels_per_degree <= 0 || (limits.blur == 0 && !eyes.any())) return std::nullopt;
  const double sigma = std::hypot(eyes.sigma(), blurred(limits.blur).sigma());  // one Gaussian after the other is one
  return EyeFilter(field.shape[0], field.shape[1], sigma * field.pixels_per_degree, eyes.chroma);
}

}  // namespace

// Two causes that know nothing of each other.
double Limits::deviation(double value) const {
  return signal_noise == 0 ? noise : std::sqrt(noise * noise + signal_noise * value * signal_noise * value);
}

LimitedField::LimitedField(const Field& field, const Limits& limits, const Nature& nature, const Clock& clock)
    : field_(field),
      limits_(limits),
      delay_(field, delays_of(limits, nature), clock),
      eye_(eye_of(field, limits, nature.eyes)) {}

void LimitedField::weaken(std::uint8_t* block) {
  std::uint8_t* start = block + field_.offset;
  if (eye_) eye_->filter(start);
  if (limits_.gain == 1) return;
  if (field_.type == Type::kU8) scale(start);
  if (field_.type == Type::kF32) scale(reinterpret_cast<float*>(start));
}

void LimitedField::disturb(std::uint8_t* block, std::uint64_t episode, std::uint64_t tick) const {
  if (!limits_.noisy()) return;
  std::uint8_t* start = block + field_.offset;
  const std::uint64_t seed = noise_seed(episode, tick, field_.name);
  if (field_.type == Type::kU8) add_noise(start, seed);
  if (field_.type == Type::kF32) add_noise(reinterpret_cast<float*>(start), seed);
}

template <typename T>
T LimitedField::bounded(double value) const {
  const double low = std::max<double>(field_.low, std::numeric_limits<T>::lowest());
  const double high = std::min<double>(field_.high, std::numeric_limits<T>::max());
  return static_cast<T>(std::clamp(std::is_integral_v<T> ? std::round(value) : value, low, high));
}

template <typename T>
void LimitedField::scale(T* values) const {
  for (std::size_t i = 0; i < field_.count(); ++i)
    values[i] = bounded<T>(limits_.gain * static_cast<double>(values[i]));
}

template <typename T>
void LimitedField::add_noise(T* values, std::uint64_t seed) const {
  Noise noise(seed);
  for (std::size_t i = 0; i < field_.count(); ++i) {
    const auto value = static_cast<double>(values[i]);
    values[i] = bounded<T>(value + limits_.deviation(value) * noise.next());
  }
}

}  // namespace mimo::observation
