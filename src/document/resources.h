// The built-in models: every .xml and .png of models/, compiled into the library by cmake/EmbedModels.cmake.
#pragma once

#include <cstddef>

namespace mimo::document {

struct Resource {
  const char* path;           // Relative to models/: "mitten.xml", "textures/face.png".
  const unsigned char* data;  // The file's bytes; one zero byte follows that is not part of size.
  std::size_t size;
};

extern const Resource kResources[];  // Sorted by path, as strcmp would.
extern const std::size_t kResourceCount;

}  // namespace mimo::document
