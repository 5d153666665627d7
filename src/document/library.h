// Where built-in models come from: the copies inside the library, or a folder that a config names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/span.h"

namespace mimo::document {

class Library {
 public:
  // An empty folder means the copies inside the library.
  explicit Library(std::string folder) : folder_(std::move(folder)) {}

  // Text of "mitten.xml", "parts/room.xml", ...; nothing if there is no such file.
  std::optional<std::string> text(const std::string& path) const;

  bool has(const std::string& path) const;

  bool built_in() const { return folder_.empty(); }
  const std::string& folder() const { return folder_; }

 private:
  std::string folder_;
};

// Bytes of a built-in file; empty if there is none.
Span<const unsigned char> built_in_file(const std::string& path);

}  // namespace mimo::document
