// Checks that many functions of the border share.
#pragma once

#include <cstdint>
#include <string>

#include "base/fail.h"
#include "base/span.h"
#include "common/ranges.h"
#include "mimo/status.h"

namespace mimo::capi {

// A number of a struct, in the range that its comment gives. `unit` is told behind the range, as " seconds".
template <typename T>
T in_range(T value, const ranges::Range<T>& range, const char* unit = "") {
  require_between(value, range.low, range.high, range.name, unit);
  return value;
}

// The same, or 0, whose meaning is told.
template <typename T>
T in_range_or_zero(T value, const ranges::Range<T>& range, const char* unit, const char* zero) {
  require(value == 0 || range.has(value), "{} is {}, expected {} to {}{}, or 0 for {}", range.name, value, range.low,
          range.high, unit, zero);
  return value;
}

// An output parameter that must be there.
template <typename T>
T& out(T* pointer, const char* argument) {
  require(pointer != nullptr, "{} is NULL", argument);
  return *pointer;
}

// A length that no memory can have was a negative number, or comes from an overflow.
template <typename T>
void check_length(std::size_t length, const char* argument) {
  constexpr std::size_t kMost = PTRDIFF_MAX / sizeof(T);
  require(length <= kMost, "{} has a length of {}, but no memory holds more than {}", argument, length, kMost);
}

// An optional buffer: NULL with length 0, or of at least `needed` elements.
template <typename T>
void check_buffer(const T* buffer, std::size_t length, std::size_t needed, const char* argument) {
  check_length<T>(length, argument);
  require(buffer != nullptr || length == 0, "{} is NULL, but its length is {}", argument, length);
  if (buffer != nullptr && length < needed) {
    const char* unit = sizeof(T) == 1 ? " bytes" : "";
    fail(Status::kBufferTooSmall, "{} has a length of {}{}, but {} are needed", argument, length, unit, needed);
  }
}

// An array that must be there unless it is empty.
template <typename T>
Span<T> array(T* data, std::size_t count, const char* argument) {
  check_length<T>(count, argument);
  require(data != nullptr || count == 0, "{} is NULL, but its length is {}", argument, count);
  return {data, count};
}

// The number of elements of an array that the caller gives.
inline void check_given(std::size_t count, std::size_t expected, const char* argument) {
  require(count == expected, "{} is {}, expected {}", argument, count, expected);
}

// The number of elements of an array that the library fills exactly. `of` says which they are.
inline void check_exact(std::size_t count, std::size_t expected, const char* argument, const std::string& of = "") {
  if (count < expected) {
    fail(Status::kBufferTooSmall, "{} is {}, but {} are needed{}", argument, count, expected, of);
  }
  require(count == expected, "{} is {}, expected {}{}", argument, count, expected, of);
}

// A config's string; NULL counts as "".
inline std::string text(const char* string) { return string == nullptr ? std::string() : std::string(string); }

// A config's string, or its default for NULL.
inline std::string text_or(const char* string, const char* standard) { return string == nullptr ? standard : string; }

// What a caller of a newer interface asks for and this library does not know: a constant, a bit, a quantity.
template <typename T>
[[noreturn]] void refuse_unknown(const char* argument, T value) {
  fail(Status::kUnsupported, "{} is {}, which needs an interface newer than {}.{}", argument, value, MIMO_API_MAJOR,
       MIMO_API_MINOR);
}

// A constant of an enumeration without gaps.
template <typename T>
void check_choice(T value, T low, T high, const char* argument) {
  if (value >= low && value <= high) return;
  fail(Status::kUnsupported, "{} is {}, which needs an interface newer than {}.{}: this one knows {} to {}", argument,
       value, MIMO_API_MAJOR, MIMO_API_MINOR, low, high);
}

inline void check_bits(std::uint32_t value, std::uint32_t known, const char* argument) {
  if ((value & ~known) == 0) return;
  fail(Status::kUnsupported, "{} is {:#x}, which needs an interface newer than {}.{}: this one knows bits of {:#x}",
       argument, value, MIMO_API_MAJOR, MIMO_API_MINOR, known);
}

// Bits of which one stands for all that there are.
inline std::uint32_t resolve_bits(std::uint32_t bits, std::uint32_t all_bit, std::uint32_t known,
                                  const char* argument) {
  check_bits(bits, known | all_bit, argument);
  return (bits & all_bit) != 0 ? known : bits;
}

// A switch; later versions may give it more positions.
inline void check_flag(std::uint32_t value, const char* argument) { check_choice(value, 0U, 1U, argument); }

// What later versions may give a meaning.
inline void check_reserved(std::uint32_t value, const char* argument) {
  if (value == 0) return;
  fail(Status::kUnsupported, "{} is {}, which needs an interface newer than {}.{}: this one knows 0", argument, value,
       MIMO_API_MAJOR, MIMO_API_MINOR);
}

}  // namespace mimo::capi
