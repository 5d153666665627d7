// A file that an asset of a document names.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>

#include "document/limits.h"

namespace mimo::document {

// ".png", in small letters; "" for a name that has none.
std::string extension_of(const std::string& path);

class LoadedFile {
 public:
  // Reads it; throws Status::kModel, with the asset's place, for what is no plain file, or too large. A file that is
  // not there is refused too.
  LoadedFile(pugi::xml_node asset, const char* attribute, const Limits& limits);

  // One of ours, which needs no check and is not read.
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
