// Files that documents name, which may be anything, and the numbers in their bytes.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <pugixml.hpp>
#include <string>

#include "document/budget.h"

namespace mimo::document {

// Numbers at a place in a file's bytes; the caller has checked that they are there.

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

// Files that documents name, which may be anything.

// Whole content of a file: of those that the limits hold, if they do, else on disk; nothing if there is none. Throws
// Status::kModel for what is no plain file (reading a device, a pipe or a folder may never end), and for one larger
// than the limits allow.
std::optional<std::string> read_file(const std::string& path, const Limits& limits);
std::optional<std::string> read_from_disk(const std::string& path, std::uint64_t most_bytes);
[[noreturn]] void fail_large(const std::string& path, std::uint64_t bytes, std::uint64_t most_bytes);

// Whether a file lies in a folder or below, links followed; "" is the working directory.
bool lies_in(const std::string& path, const std::string& folder);

// A file that an asset of a document names.

// ".png", in small letters; "" for a name that has none.
std::string extension_of(const std::string& path);

class LoadedFile {
 public:
  // Reads it; throws Status::kModel, with the asset's place, for what is no plain file, or too large. A file that is
  // not there is refused too.
  LoadedFile(pugi::xml_node asset, const char* attribute, const Limits& limits);

  // A built-in file, which needs no check and is not read.
  bool built_in() const { return built_in_; }
  const std::string& bytes() const { return bytes_; }
  const std::string& path() const { return path_; }
  std::string extension() const { return extension_of(path_); }

  // Another file that this one names; nothing if it cannot be opened. Throws as the constructor does.
  std::optional<std::string> read(const std::string& path, const Limits& limits) const;

  // "room.xml, line 12: file horse.stl ..."
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  pugi::xml_node asset_;
  std::string path_, bytes_;
  bool built_in_ = false;
};

}  // namespace mimo::document
