#include "observation/limited_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/delay.h"
#include "base/fail.h"
#include "base/noise.h"
#include "observation/blur.h"

namespace mimo::observation {
namespace {

bool is_picture(const Field& field) { return field.type == Type::kU8 && field.shape.size() == 3; }

}  // namespace

LimitedField::LimitedField(const Field& field, const Limits& limits, double step)
    : field_(field), limits_(limits), delay_(steps_of_delay(limits.delay, step)) {
  if (limits_.blur > 0) {
    require(is_picture(field_) && field_.pixels_per_degree > 0, "blur is {}, but {} is no picture in colour",
            limits_.blur, field_.name);
    kernel_ = blur_kernel(limits_.blur, field_.pixels_per_degree);
    rows_.resize(field_.count());
  }
  if (late()) past_.resize((delay_ + 1) * field_.bytes());
}

void LimitedField::weaken(std::uint8_t* block, std::uint64_t episode, std::uint64_t step) {
  std::uint8_t* start = block + field_.offset;
  if (!kernel_.empty()) blur(start, field_.shape[0], field_.shape[1], kernel_, rows_);
  if (limits_.gain == 1 && limits_.noise == 0) return;
  const std::uint64_t seed = noise_seed(episode, step, field_.name);
  if (field_.type == Type::kU8) scale_and_add_noise(start, seed);
  if (field_.type == Type::kF32) scale_and_add_noise(reinterpret_cast<float*>(start), seed);
}

// What comes out stays between the bounds that the field promises, and is a number that its type has: a field without
// bounds ends at the largest one.
template <typename T>
void LimitedField::scale_and_add_noise(T* values, std::uint64_t seed) const {
  Noise noise(seed);
  const bool whole = std::is_integral_v<T>;
  const double low = std::max<double>(field_.low, std::numeric_limits<T>::lowest());
  const double high = std::min<double>(field_.high, std::numeric_limits<T>::max());
  for (std::size_t i = 0; i < field_.count(); ++i) {
    double value = limits_.gain * static_cast<double>(values[i]);
    if (limits_.noise > 0) value += limits_.noise * noise.next();
    values[i] = static_cast<T>(std::clamp(whole ? std::round(value) : value, low, high));
  }
}

std::size_t LimitedField::slot_offset(std::uint64_t step) const {
  return static_cast<std::size_t>(step % (std::uint64_t{delay_} + 1)) * field_.bytes();
}

void LimitedField::begin(const std::uint8_t* block) {
  begun_ = true;
  for (std::size_t at = 0; at < past_.size(); at += field_.bytes()) {
    std::copy_n(block + field_.offset, field_.bytes(), past_.data() + at);
  }
}

void LimitedField::keep(const std::uint8_t* block, std::uint64_t step) {
  if (!late()) return;
  if (!begun_) return begin(block);
  std::copy_n(block + field_.offset, field_.bytes(), slot(step));
}

// The slot of the next step still holds what is `delay` steps old.
void LimitedField::recall(std::uint8_t* block, std::uint64_t step) const {
  if (late() && begun_) std::copy_n(past_.data() + slot_offset(step + 1), field_.bytes(), block + field_.offset);
}

Section LimitedField::section() {
  Hash kind;
  kind.add(std::uint64_t{delay_});
  kind.add(static_cast<std::uint64_t>(field_.type));
  for (const std::size_t extent : field_.shape) kind.add(std::uint64_t{extent});
  Section section;
  section.name = "delay/" + field_.name;
  section.kind = kind.value();
  section.essential = false;
  section.save = [this](ByteWriter& to) {
    to.put(begun_);
    to.put(Span<const std::uint8_t>(past_));
  };
  section.load = [this](ByteReader& from) {
    begun_ = from.take_flag();
    from.take(Span<std::uint8_t>(past_));
  };
  section.forget = [this] { forget(); };
  return section;
}

}  // namespace mimo::observation
