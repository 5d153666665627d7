#include "recording/difference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace mimo::recording {
namespace {

template <typename T>
double largest(Span<const std::uint8_t> a, Span<const std::uint8_t> b) {
  double largest = 0;
  for (std::size_t at = 0; at < a.size(); at += sizeof(T)) {
    if (std::memcmp(a.data() + at, b.data() + at, sizeof(T)) == 0) continue;
    T one, other;
    std::memcpy(&one, a.data() + at, sizeof one);
    std::memcpy(&other, b.data() + at, sizeof other);
    const double difference = std::abs(static_cast<double>(one) - static_cast<double>(other));
    largest = std::max(largest, std::isfinite(difference) ? difference : std::numeric_limits<double>::max());
  }
  return largest;
}

}  // namespace

double largest_difference(observation::Type type, Span<const std::uint8_t> one, Span<const std::uint8_t> other) {
  switch (type) {
    case observation::Type::kU8: return largest<std::uint8_t>(one, other);
    case observation::Type::kI32: return largest<std::int32_t>(one, other);
    case observation::Type::kF32: return largest<float>(one, other);
    case observation::Type::kF64: return largest<double>(one, other);
  }
  return 0;
}

}  // namespace mimo::recording
