// Textures as pixels, and where a mesh's vertices lie in them. The six faces of a cube texture (+x -x +y -y +z -z) are
// one picture, one above the other.
#pragma once

#include <mujoco/mjmodel.h>

#include <cstdint>

#include "base/span.h"
#include "geometry/mesh.h"
#include "mimo/experimental/looks.h"
#include "render/surfaces.h"

namespace mimo::geometry {

// Of the header.
enum class TextureType : std::int32_t { kFlat = MIMO_TEXTURE_FLAT, kCube = MIMO_TEXTURE_CUBE, kSky = MIMO_TEXTURE_SKY };

struct TextureSize {
  TextureType type = TextureType::kFlat;
  int width = 0;
  int height = 0;  // of all faces together
  bool cube() const { return type != TextureType::kFlat; }
};

TextureSize size_of(const mjModel& model, int texture);
// Red, green, blue and 255 of each pixel; row 0 first, where the second coordinate of a vertex is 0.
void read_pixels(const mjModel& model, int texture, Span<std::uint8_t> rgba);

// Gives all vertices their places in a texture. Vertices where faces of a cube texture meet become several.
void lay(Mesh& mesh, const render::TextureMapping& mapping, const TextureSize& size);

}  // namespace mimo::geometry
