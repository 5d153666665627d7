#include "observation/limited_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bytes.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/random.h"

namespace mimo::observation {
namespace {

bool is_picture(const Field& field) { return field.type == Type::kU8 && field.shape.size() == 3; }

std::vector<double> delays_of(const Limits& limits, const Nature& nature) {
  return limits.delay > 0 ? std::vector<double>{limits.delay} : nature.delays;
}

Eyesight seen_with(const Limits& limits, Eyesight eyes) {
  eyes.blur = limits.blur;
  return eyes;
}

std::optional<EyeFilter> eye_of(const Field& field, const Limits& limits, const Eyesight& nature) {
  const bool in_colour = is_picture(field) && field.is_picture();
  require(limits.blur == 0 || in_colour, "blur is {}, but {} is not a colour picture", limits.blur, field.name);
  if (in_colour && field.pinhole.parallel) {  // its pixels have no angles
    require(limits.blur == 0, "blur is {}, but {} is the picture of an orthographic camera", limits.blur, field.name);
    return std::nullopt;
  }
  const Eyesight eyes = seen_with(limits, nature);
  if (!in_colour || !eyes.any()) return std::nullopt;
  return EyeFilter(field.shape[0], field.shape[1], field.pinhole.focal_y * kDegree, eyes);
}

std::optional<Foveation> fovea_of(const Field& field) {
  if (field.foveation == 0) return std::nullopt;
  return Foveation(field.shape[0], field.shape[1], map_of(field));
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
      tick_(clock.tick),
      eye_(eye_of(field, limits, nature.eyes)),
      fovea_(fovea_of(field)) {}

void LimitedField::weaken(std::uint8_t* block, std::uint64_t tick, Memory memory) {
  std::uint8_t* start = block + field_.offset;
  if (eye_) see(start, tick, memory);
  if (fovea_) fovea_->filter(start);
  if (limits_.gain == 1) return;
  if (field_.type == Type::kU8) scale(start);
  if (field_.type == Type::kF32) scale(reinterpret_cast<float*>(start));
}

void LimitedField::see(std::uint8_t* rgb, std::uint64_t tick, Memory memory) {
  if (eye_->remembers()) eye_->advance(static_cast<double>(tick - seen_at_) * tick_);
  if (memory == Memory::kLeave) return eye_->glance(rgb);
  eye_->filter(rgb);
  seen_at_ = tick;
}

void LimitedField::forget() {
  delay_.forget();
  if (eye_) forget_sight();
}

void LimitedField::forget_sight() {
  eye_->begin();
  seen_at_ = 0;
}

void LimitedField::list(std::vector<Section>& sections) {
  if (late()) sections.push_back(delay_.section());
  if (flickers()) sections.push_back(sight());
}

Section LimitedField::sight() {
  Hash kind;
  for (const std::size_t extent : field_.shape) kind.add(std::uint64_t{extent});
  kind.add(std::uint64_t{eye_->colours()});
  Section section;
  section.name = "sight/" + field_.name;
  section.kind = kind.value();
  section.essential = false;
  section.save = [this](ByteWriter& to) {
    to.put(seen_at_);
    eye_->save(to);
  };
  section.load = [this](ByteReader& from) {
    seen_at_ = from.take<std::uint64_t>();
    eye_->load(from);
  };
  section.forget = [this] { forget_sight(); };
  return section;
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
