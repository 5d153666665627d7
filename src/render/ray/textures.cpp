#include "render/ray/textures.h"

#include <algorithm>
#include <limits>

#include "base/fail.h"

namespace mimo::render::ray {
namespace {

std::uint32_t channel(std::uint32_t texel, int k) { return (texel >> (8 * k)) & 255U; }

// The next smaller level: the mean of the texels that a texel of it covers (two, or three at an odd edge).
void shrink(const std::uint32_t* from, int width, int height, std::uint32_t* to) {
  const int to_width = std::max(1, width / 2);
  const int to_height = std::max(1, height / 2);
  for (int y = 0; y < to_height; ++y) {
    const int y0 = y * height / to_height;
    const int y1 = std::max(y0 + 1, (y + 1) * height / to_height);
    for (int x = 0; x < to_width; ++x) {
      const int x0 = x * width / to_width;
      const int x1 = std::max(x0 + 1, (x + 1) * width / to_width);
      std::uint32_t sum[3] = {0, 0, 0};
      for (int v = y0; v < y1; ++v) {
        for (int u = x0; u < x1; ++u) {
          for (int k = 0; k < 3; ++k) sum[k] += channel(from[v * width + u], k);
        }
      }
      const std::uint32_t count = static_cast<std::uint32_t>((y1 - y0) * (x1 - x0));
      std::uint32_t texel = 0;
      for (int k = 0; k < 3; ++k) texel |= ((sum[k] + count / 2) / count) << (8 * k);
      to[y * to_width + x] = texel;
    }
  }
}

}  // namespace

Textures::Textures(const mjModel& model) {
  textures_.resize(static_cast<std::size_t>(model.ntex));
  std::size_t size = 0;
  for (int i = 0; i < model.ntex; ++i) {
    Texture& texture = textures_[i];
    texture.cube = model.tex_type[i] != mjTEXTURE_2D;
    texture.sky = model.tex_type[i] == mjTEXTURE_SKYBOX;
    texture.width = model.tex_width[i];
    texture.height = texture.cube ? texture.width : model.tex_height[i];
    for (int w = texture.width, h = texture.height; texture.levels < Texture::kMaxLevels; w /= 2, h /= 2) {
      texture.offset[texture.levels++] = static_cast<std::int32_t>(size);
      size += static_cast<std::size_t>(std::max(w, 1)) * std::max(h, 1) * (texture.cube ? 6 : 1);
      if (size > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max() / 4)) {
        fail(Status::kUnsupported, "the model's textures are too large for the ray renderer");
      }
      if (w <= 1 && h <= 1) break;
    }
  }
  texels_.resize(size);
  for (int i = 0; i < model.ntex; ++i) {
    const Texture& texture = textures_[i];
    const unsigned char* rgb = model.tex_rgb + model.tex_adr[i];
    const std::size_t face = static_cast<std::size_t>(texture.width) * texture.height;
    // A cube texture as high as wide is one picture for all six faces.
    const bool same_faces = texture.cube && model.tex_height[i] == model.tex_width[i];
    for (int f = 0; f < (texture.cube ? 6 : 1); ++f) {
      std::uint32_t* to = texels_.data() + texture.offset[0] + f * face;
      const unsigned char* from = rgb + (same_faces ? 0 : 3 * f * face);
      for (std::size_t k = 0; k < face; ++k, from += 3) {
        to[k] = static_cast<std::uint32_t>(from[0]) | static_cast<std::uint32_t>(from[1]) << 8 |
                static_cast<std::uint32_t>(from[2]) << 16;
      }
      int w = texture.width;
      int h = texture.height;
      for (int level = 0; level + 1 < texture.levels; ++level) {
        const int next_w = std::max(1, w / 2);
        const int next_h = std::max(1, h / 2);
        shrink(texels_.data() + texture.offset[level] + static_cast<std::size_t>(f) * w * h, w, h,
               texels_.data() + texture.offset[level + 1] + static_cast<std::size_t>(f) * next_w * next_h);
        w = next_w;
        h = next_h;
      }
    }
  }
}

const Texture* Textures::sky() const {
  const auto found = std::find_if(textures_.begin(), textures_.end(), [](const Texture& t) { return t.sky; });
  return found == textures_.end() ? nullptr : &*found;
}

}  // namespace mimo::render::ray
