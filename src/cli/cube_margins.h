// Cubes' textures for programs that draw them with mipmaps: a cube's six faces lie one above the other in one picture,
// and in the smaller pictures of it a face's border takes the next face's colours. So each face gets a margin.
#pragma once

#include <cstdint>
#include <vector>

#include "mimo/mimo.hpp"

namespace cli {

// The texture with margins around a cube's faces, which repeat their borders; other textures as they are.
mimo::Texture with_margins(mimo::Texture texture);

// Where a mesh's texcoords, two numbers each, lie in that picture.
std::vector<float> with_margins(std::vector<float> texcoords, const mimo::Texture& texture);

}  // namespace cli
