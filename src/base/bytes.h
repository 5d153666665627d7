// Plain numbers to and from bytes, one after the other, as this machine stores them. What makes up a world's state.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "base/fail.h"
#include "base/span.h"

namespace mimo {

template <typename T>
constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// Writes into a caller's bytes; made without any, it only counts what it would write.
class ByteWriter {
 public:
  ByteWriter() = default;
  explicit ByteWriter(Span<std::uint8_t> to) : to_(to) {}

  template <typename T>
  void put(Span<const T> values) {
    static_assert(kIsPlain<T>);
    const std::size_t bytes = values.size() * sizeof(T);
    if (to_.data() != nullptr && bytes > 0) {
      if (bytes > to_.size() - size_) fail(Status::kInternal, "{} bytes of state do not fit", size_ + bytes);
      std::memcpy(to_.data() + size_, values.data(), bytes);
    }
    size_ += bytes;
  }

  template <typename T>
  void put(const T& value) {
    put(Span<const T>(&value, 1));
  }

  std::size_t size() const { return size_; }

 private:
  Span<std::uint8_t> to_;
  std::size_t size_ = 0;
};

// Reads what a ByteWriter wrote. Throws Status::kInvalidArgument where there is less than asked for.
class ByteReader {
 public:
  explicit ByteReader(Span<const std::uint8_t> from) : from_(from) {}

  template <typename T>
  void take(Span<T> values) {
    static_assert(kIsPlain<T>);
    const std::size_t bytes = values.size() * sizeof(T);
    require(bytes <= left(), "the state ends {} bytes early", bytes - left());
    if (bytes > 0) std::memcpy(values.data(), from_.data() + at_, bytes);
    at_ += bytes;
  }

  template <typename T>
  T take() {
    T value{};
    take(Span<T>(&value, 1));
    return value;
  }

  // Those that cannot be just anything.
  bool take_flag() {
    const auto value = take<std::uint8_t>();
    require(value <= 1, "the state holds {} where only 0 or 1 can be", value);
    return value == 1;
  }
  double take_finite(const char* what) {
    const double value = take<double>();
    require(std::isfinite(value), "the state holds {} for {}, expected a finite number", value, what);
    return value;
  }

  // The next bytes as they are; they are then read past.
  Span<const std::uint8_t> skip(std::size_t bytes) {
    require(bytes <= left(), "the state ends {} bytes early", bytes - left());
    at_ += bytes;
    return from_.part(at_ - bytes, bytes);
  }

  std::size_t left() const { return from_.size() - at_; }

 private:
  Span<const std::uint8_t> from_;
  std::size_t at_ = 0;
};

}  // namespace mimo
