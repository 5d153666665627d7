// A 64-bit fingerprint of bytes, 8 at a time. Each step maps different words to different results, so a change within
// any one word is always noticed. No defence against someone who wants a collision.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "base/span.h"

namespace mimo {

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
