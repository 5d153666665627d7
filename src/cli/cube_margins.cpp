#include "cli/cube_margins.h"

#include <algorithm>
#include <cmath>

namespace cli {
namespace {

constexpr std::uint32_t kFaces = 6, kBytes = 4;
constexpr std::uint32_t kPartOfFace =
    8;  // a margin is this part of a face: mipmaps of an eighth of the size have no seams

std::uint32_t margin_of(const mimo::Texture& texture) {
  const bool cube = texture.type == MIMO_TEXTURE_CUBE && texture.height == kFaces * texture.width;
  return cube ? texture.width / kPartOfFace : 0;
}

}  // namespace

mimo::Texture with_margins(mimo::Texture texture) {
  const std::uint32_t edge = texture.width, margin = margin_of(texture), wide = edge + 2 * margin;
  if (margin == 0) return texture;
  mimo::Texture padded{texture.type, wide, kFaces * wide, {}};
  padded.pixels.reserve(std::size_t{kBytes} * wide * padded.height);
  const auto inside = [&](std::uint32_t at) { return std::clamp(at, margin, margin + edge - 1) - margin; };
  for (std::uint32_t row = 0; row < padded.height; ++row) {
    const std::size_t from = std::size_t{row / wide} * edge + inside(row % wide);
    for (std::uint32_t column = 0; column < wide; ++column) {
      const auto pixel = texture.pixels.begin() + static_cast<std::ptrdiff_t>(kBytes * (from * edge + inside(column)));
      padded.pixels.insert(padded.pixels.end(), pixel, pixel + kBytes);
    }
  }
  return padded;
}

std::vector<float> with_margins(std::vector<float> texcoords, const mimo::Texture& texture) {
  const double edge = texture.width, margin = margin_of(texture);
  if (margin == 0) return texcoords;
  const auto inside = [&](double at) { return (margin + at * edge) / (edge + 2 * margin); };
  for (std::size_t i = 0; i + 1 < texcoords.size(); i += 2) {
    const double down = double{texcoords[i + 1]} * kFaces;
    const double face = std::clamp(std::floor(down), 0.0, kFaces - 1.0);
    texcoords[i] = static_cast<float>(inside(texcoords[i]));
    texcoords[i + 1] = static_cast<float>((face + inside(down - face)) / kFaces);
  }
  return texcoords;
}

}  // namespace cli
