// The built-in models: their documents and pictures, inside the library or in a folder that a config names.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/span.h"
#include "engine/model.h"

namespace mimo::document {

// The built-in models: every .xml and .png of models/, compiled into the library by cmake/EmbedModels.cmake.

struct Resource {
  const char* path;           // Relative to models/: "mitten.xml", "textures/face.png".
  const unsigned char* data;  // The file's bytes; one zero byte follows that is not part of size.
  std::size_t size;
};

extern const Resource kResources[];  // Sorted by path, as strcmp would.
extern const std::size_t kResourceCount;

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

// Built-in pictures, each decoded once in a process: the cubes of one scene name some of them a dozen times, and
// MuJoCo's compiler would decode them each time.

// What a built-in picture is called when it is decoded; other files keep their names.
std::string decoded_name(const std::string& name);

// In place of those of these built-in files that are pictures, what is decoded of them, which lives as long as the
// library is loaded.
void decode_pictures(std::vector<engine::Asset>& assets);

}  // namespace mimo::document
