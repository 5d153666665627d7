// glTF 2.0 files in one piece: JSON, and the numbers and pictures that it refers to.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mimo/mimo.hpp"

namespace cli {

// Cubes' textures for programs that draw them with mipmaps: a cube's six faces lie one above the other in one picture,
// and in the smaller pictures of it a face's border takes the next face's colours. So each face gets a margin.

// The texture with margins around a cube's faces, which repeat their borders; other textures as they are.
mimo::Texture with_margins(mimo::Texture texture);

// Where a mesh's texcoords, two numbers each, lie in that picture.
std::vector<float> with_margins(std::vector<float> texcoords, const mimo::Texture& texture);

class Glb {
 public:
  using Json = nlohmann::ordered_json;

  Glb();

  // Each adds to the file and gives the number by which the document refers to it.
  std::size_t add_floats(const std::vector<float>& values, std::size_t width, bool vertices = false);
  std::size_t add_indices(const std::vector<std::uint32_t>& values);
  std::size_t add_texture(const mimo::Texture& texture, const std::string& name);  // as PNG
  std::size_t add(const char* list, Json element);

  void write(const std::string& path) const;

 private:
  std::size_t add_view(const void* bytes, std::size_t size, int target = 0);

  Json document_;
  std::string data_;
};

}  // namespace cli
