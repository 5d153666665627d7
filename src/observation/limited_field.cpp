#include "observation/limited_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fail.h"
#include "base/random.h"
#include "observation/blur.h"

namespace mimo::observation {
namespace {

bool is_picture(const Field& field) { return field.type == Type::kU8 && field.shape.size() == 3; }

// Two independent numbers of the normal distribution (Box and Muller, 1958).
std::pair<double, double> normal_pair(Random& random) {
  constexpr double kTurn = 6.28318530717958647692;
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  const double angle = kTurn * random.uniform();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

LimitedField::LimitedField(const Field& field, const Limits& limits) : field_(field), limits_(limits) {
  if (limits_.blur > 0) {
    require(is_picture(field_) && field_.pixels_per_degree > 0, "blur is {}, but {} is no picture in colour",
            limits_.blur, field_.name);
    kernel_ = blur_kernel(limits_.blur, field_.pixels_per_degree);
    rows_.resize(field_.count());
  }
  if (limits_.delay > 0) past_.resize((static_cast<std::size_t>(limits_.delay) + 1) * field_.bytes());
}

void LimitedField::weaken(std::uint8_t* block, std::uint64_t seed) {
  std::uint8_t* start = block + field_.offset;
  if (!kernel_.empty()) blur(start, field_.shape[0], field_.shape[1], kernel_, rows_);
  if (limits_.gain == 1 && limits_.noise == 0) return;
  if (field_.type == Type::kU8) scale_and_add_noise(start, seed);
  if (field_.type == Type::kF32) scale_and_add_noise(reinterpret_cast<float*>(start), seed);
}

// What comes out stays between the bounds that the field promises, and is a number that its type has: a field without
// bounds ends at the largest one.
template <typename T>
void LimitedField::scale_and_add_noise(T* values, std::uint64_t seed) const {
  Random random(seed);
  std::pair<double, double> noise{};
  const bool whole = std::is_integral_v<T>;
  const double low = std::max<double>(field_.low, std::numeric_limits<T>::lowest());
  const double high = std::min<double>(field_.high, std::numeric_limits<T>::max());
  for (std::size_t i = 0; i < field_.count(); ++i) {
    if (limits_.noise > 0 && i % 2 == 0) noise = normal_pair(random);
    const double value =
        limits_.gain * static_cast<double>(values[i]) + limits_.noise * (i % 2 == 0 ? noise.first : noise.second);
    values[i] = static_cast<T>(std::clamp(whole ? std::round(value) : value, low, high));
  }
}

std::size_t LimitedField::slot_offset(std::uint64_t step) const {
  return static_cast<std::size_t>(step % (static_cast<std::uint64_t>(limits_.delay) + 1)) * field_.bytes();
}

void LimitedField::begin(const std::uint8_t* block) {
  for (std::size_t at = 0; at < past_.size(); at += field_.bytes()) {
    std::copy_n(block + field_.offset, field_.bytes(), past_.data() + at);
  }
}

void LimitedField::keep(const std::uint8_t* block, std::uint64_t step) {
  if (!past_.empty()) std::copy_n(block + field_.offset, field_.bytes(), slot(step));
}

// The slot of the next step still holds what is `delay` steps old.
void LimitedField::recall(std::uint8_t* block, std::uint64_t step) const {
  if (!past_.empty()) std::copy_n(past_.data() + slot_offset(step + 1), field_.bytes(), block + field_.offset);
}

}  // namespace mimo::observation
