// Plain numbers to and from bytes as this machine stores them, sections of a state, and hashes.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <type_traits>

#include "base/fail.h"
#include "base/span.h"

namespace mimo {

// Plain numbers to and from bytes, one after the other, as this machine stores them. What makes up a world's state.

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
  Span<const std::uint8_t> skip(std::uint64_t bytes) {  // as stored: 32-bit systems count fewer
    require(bytes <= left(), "the state ends {} bytes early", bytes - left());
    const Span<const std::uint8_t> skipped = from_.part(at_, static_cast<std::size_t>(bytes));
    at_ += skipped.size();
    return skipped;
  }

  std::size_t left() const { return from_.size() - at_; }

 private:
  Span<const std::uint8_t> from_;
  std::size_t at_ = 0;
};

// A part of a state that has a name: what saves it, and what takes it back.

struct Section {
  std::string name;           // "physics", "delay/anna/touch/force"
  std::uint32_t version = 1;  // of its bytes; what has a lower one is read as well
  std::uint64_t kind = 0;     // what has to be the same for the bytes to mean anything: a hash of sizes and names
  bool essential = true;      // without it there is no going on; else it is a memory, which may start afresh

  // Always the same number of bytes.
  std::function<void(ByteWriter& to)> save;
  // A load that throws may leave it half loaded; what was there before is then loaded again.
  std::function<void(ByteReader& from)> load;
  // Where given, it throws for what load would not take, and load does not throw.
  std::function<void(ByteReader& from)> check;
  // Of a memory: starts afresh.
  std::function<void()> forget;
};

// A 64-bit fingerprint of bytes, 8 at a time. Each step maps different words to different results, so a change within
// any one word is always noticed. No defence against someone who wants a collision.

class Hash {
 public:
  // Multiplication carries differences upwards, the shift brings them down again.
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 32;
  }

  void add(Span<const std::uint8_t> bytes) {
    std::size_t at = 0;
    for (; bytes.size() - at >= 8; at += 8) add(word(bytes.data() + at, 8));
    if (at < bytes.size()) add(word(bytes.data() + at, bytes.size() - at));
    add(std::uint64_t{bytes.size()});
  }

  void add(const std::string& text) { add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}); }

  // Spreads what the last words changed over all bits.
  std::uint64_t value() const {
    std::uint64_t z = value_;
    z = (z ^ (z >> 33)) * 0xff51afd7ed558ccdu;
    z = (z ^ (z >> 33)) * 0xc4ceb9fe1a85ec53u;
    return z ^ (z >> 33);
  }

 private:
  static std::uint64_t word(const std::uint8_t* bytes, std::size_t count) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, count);
    return word;
  }

  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace mimo
