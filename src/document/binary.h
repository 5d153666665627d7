// Numbers at a place in a file's bytes; the caller has checked that they are there.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace mimo::document {

template <typename T>
T value_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

inline std::int32_t little_endian(const std::string& bytes, std::size_t at) {
  return value_at<std::int32_t>(bytes, at);
}

inline std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// Bytes of the mark of UTF-8 that some editors put before a text.
inline std::size_t mark_of_utf8(const std::string& bytes) { return bytes.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0; }

}  // namespace mimo::document
