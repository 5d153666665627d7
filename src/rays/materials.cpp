#include "rays/materials.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/fail.h"
#include "base/functions.h"
#include "rays/vectors.h"
#include "render/surfaces.h"

namespace mimo::rays {
namespace {

std::uint32_t channel(std::uint32_t texel, int k) { return (texel >> (8 * k)) & 255U; }

// The two texels of a row between which the middle of a texel of a shorter row lies, and how near it is to the second.
struct Middle {
  int first, second;
  float share;
};

class Middles {
 public:
  Middles(int from, int to) : from_(from), scale_(static_cast<float>(from) / static_cast<float>(to)) {}

  Middle of(int i) const {
    const float place = (static_cast<float>(i) + 0.5F) * scale_ - 0.5F;
    const int first = std::clamp(static_cast<int>(std::floor(place)), 0, from_ - 1);
    return {first, std::min(first + 1, from_ - 1), std::max(place - static_cast<float>(first), 0.0F)};
  }

 private:
  int from_;
  float scale_;
};

// One level of a texture, or of a face of a cube: the texels within its border.
class Level {
 public:
  Level(std::uint32_t* origin, int width, int height) : origin_(origin), width_(width), height_(height) {}

  std::uint32_t& at(int x, int y) const { return origin_[static_cast<std::ptrdiff_t>(y) * (width_ + 2) + x]; }
  int width() const { return width_; }
  int height() const { return height_; }

  // Pixels of so many bytes, row by row.
  template <int kChannels>
  void read(const unsigned char* from) const {
    constexpr int kGreen = kChannels < 3 ? 0 : 1, kBlue = kChannels < 3 ? 0 : 2;  // of fewer the first is grey
    for (int y = 0; y < height_; ++y) {
      std::uint32_t* row = &at(0, y);
      for (int x = 0; x < width_; ++x, from += kChannels) {
        row[x] = static_cast<std::uint32_t>(from[0]) | static_cast<std::uint32_t>(from[kGreen]) << 8 |
                 static_cast<std::uint32_t>(from[kBlue]) << 16;
      }
    }
  }
  void read(const unsigned char* from, int channels) const {
    switch (channels) {
      case 1: return read<1>(from);
      case 2: return read<2>(from);
      case 3: return read<3>(from);
      default: return read<4>(from);
    }
  }

  // Each texel becomes another, channel by channel.
  void map(const std::array<unsigned char, 256>& to) const {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        std::uint32_t& texel = at(x, y);
        texel = static_cast<std::uint32_t>(to[channel(texel, 0)]) |
                static_cast<std::uint32_t>(to[channel(texel, 1)]) << 8 |
                static_cast<std::uint32_t>(to[channel(texel, 2)]) << 16;
      }
    }
  }

  // Each texel becomes what lies in the middle of the larger level's texels that it covers, as graphics cards and Mesa
  // have it: the mean of two a side, or at odd sizes of the two nearest to the middle, by how near they are.
  void shrink(const Level& from) const {
    if (from.width_ == 2 * width_ && from.height_ == 2 * height_) return halve(from);
    const Middles across(from.width_, width_), down(from.height_, height_);
    for (int y = 0; y < height_; ++y) {
      const Middle v = down.of(y);
      for (int x = 0; x < width_; ++x) {
        const Middle u = across.of(x);
        std::uint32_t texel = 0;
        for (int k = 0; k < 3; ++k) {
          const auto mixed = [&](int row) {
            const auto first = static_cast<float>(channel(from.at(u.first, row), k));
            return first + u.share * (static_cast<float>(channel(from.at(u.second, row), k)) - first);
          };
          const float first = mixed(v.first);
          texel |= static_cast<std::uint32_t>(first + v.share * (mixed(v.second) - first) + 0.5F) << (8 * k);
        }
        at(x, y) = texel;
      }
    }
  }

  void fill_border(bool wrap) const {
    const auto inside = [wrap](int i, int size) { return wrap ? (i + size) % size : std::clamp(i, 0, size - 1); };
    const auto fill = [&](int x, int y) { at(x, y) = at(inside(x, width_), inside(y, height_)); };
    for (int x = -1; x <= width_; ++x) {
      fill(x, -1);
      fill(x, height_);
    }
    for (int y = 0; y < height_; ++y) {
      fill(-1, y);
      fill(width_, y);
    }
  }

 private:
  // The same where each texel covers four: red and blue are added in one word, green in another.
  void halve(const Level& from) const {
    constexpr std::uint32_t kRedBlue = 0xff00ff, kGreen = 0xff;
    for (int y = 0; y < height_; ++y) {
      const std::uint32_t* upper = &from.at(0, 2 * y);
      const std::uint32_t* lower = &from.at(0, 2 * y + 1);
      std::uint32_t* to = &at(0, y);
      for (int x = 0; x < width_; ++x, upper += 2, lower += 2) {
        const std::uint32_t a = upper[0], b = upper[1], c = lower[0], d = lower[1];
        const std::uint32_t red_blue = (a & kRedBlue) + (b & kRedBlue) + (c & kRedBlue) + (d & kRedBlue) + 0x20002;
        const std::uint32_t green = (a >> 8 & kGreen) + (b >> 8 & kGreen) + (c >> 8 & kGreen) + (d >> 8 & kGreen) + 2;
        to[x] = (red_blue >> 2 & kRedBlue) | (green >> 2 & kGreen) << 8;
      }
    }
  }

  std::uint32_t* origin_;
  int width_, height_;
};

// The light that numbers coded by sRGB stand for (IEC 61966-2-1).
std::array<unsigned char, 256> decoded_srgb() {
  std::array<unsigned char, 256> light;
  for (int i = 0; i < 256; ++i) {
    const double code = i / 255.0;
    const double linear = code <= 0.04045 ? code / 12.92 : fixed::pow((code + 0.055) / 1.055, 2.4);
    light[i] = static_cast<unsigned char>(std::lround(255 * linear));
  }
  return light;
}

// The textures of a scene fill tens of megabytes, and half of the time that takes is the system's for pages of 4 kB.
// Linux has larger ones for those who ask. Memory of this size malloc takes from the system, and gives it back as a
// whole.
void ask_for_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21;
  if (bytes < 16 * kPage) return;
  const auto start = (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) / kPage * kPage;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / kPage * kPage;
  madvise(reinterpret_cast<void*>(start), end - start, MADV_HUGEPAGE);  // without it all is as usual
#endif
}

std::size_t bordered(int width, int height) {
  return static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(height + 2);
}

}  // namespace

// A face with all its levels.
void Textures::draw(const Texture& texture, int face, const unsigned char* pixels, int channels, bool srgb) {
  int width = texture.width;
  int height = texture.height;
  const auto level_at = [&](int level) {
    return Level(texels_.get() + texture.origin[level] + face * bordered(width, height), width, height);
  };
  Level level = level_at(0);
  level.read(pixels, channels);
  if (srgb) level.map(decoded_srgb());
  level.fill_border(!texture.cube);
  for (int k = 1; k < texture.levels; ++k) {
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
    const Level next = level_at(k);
    next.shrink(level);
    next.fill_border(!texture.cube);
    level = next;
  }
}

// Most cubes show one picture or one colour on several faces.
void Textures::repeat(const Texture& texture, int face, int earlier) {
  int width = texture.width;
  int height = texture.height;
  for (int k = 0; k < texture.levels; ++k) {
    const std::size_t count = bordered(width, height);
    std::uint32_t* const first = texels_.get() + texture.origin[k] - (width + 3);  // of the first face, with its border
    std::copy_n(first + count * static_cast<std::size_t>(earlier), count,
                first + count * static_cast<std::size_t>(face));
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
  }
}

Textures::Textures(const render::Textures& given) {
  textures_.resize(static_cast<std::size_t>(given.count));
  for (int i = 0; i < given.count; ++i) {
    Texture& texture = textures_[i];
    texture.cube = given.types[i] != render::kFlatTexture;
    texture.sky = given.types[i] == render::kSkyTexture;
    texture.width = given.widths[i];
    texture.height = texture.cube ? texture.width : given.heights[i];
    for (int w = texture.width, h = texture.height;; w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
      texture.origin[texture.levels++] = static_cast<std::int32_t>(size_) + w + 3;
      size_ += bordered(w, h) * (texture.cube ? 6 : 1);
      if (size_ > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max() / 4)) {
        fail(Status::kUnsupported, "the textures are too large for the ray renderer");
      }
      if ((w == 1 && h == 1) || texture.levels == Texture::kMaxLevels) break;
    }
  }
  ++size_;  // texels are read in pairs
  texels_.reset(new std::uint32_t[size_]);
  ask_for_large_pages(texels_.get(), size_ * sizeof(std::uint32_t));
  texels_[size_ - 1] = 0;
  const unsigned char* pixels = given.pixels;
  for (int i = 0; i < given.count; ++i) {
    const Texture& texture = textures_[i];
    const int channels = given.channels == nullptr ? 3 : given.channels[i];
    const std::size_t face_bytes = static_cast<std::size_t>(channels) * texture.width * texture.height;
    // A cube texture as high as wide is one picture for all six faces.
    const bool one_picture = texture.cube && given.heights[i] == given.widths[i];
    const auto pixels_of = [&](int face) { return pixels + (one_picture ? 0 : face_bytes * face); };
    for (int face = 0; face < (texture.cube ? 6 : 1); ++face) {
      int like = 0;
      while (like < face && std::memcmp(pixels_of(like), pixels_of(face), face_bytes) != 0) ++like;
      if (like < face) {
        repeat(texture, face, like);
      } else {
        draw(texture, face, pixels_of(face), channels, given.is_srgb(i));
      }
    }
    pixels += static_cast<std::size_t>(channels) * given.widths[i] * given.heights[i];
  }
}

const Texture* Textures::sky() const {
  const auto found = std::find_if(textures_.begin(), textures_.end(), [](const Texture& t) { return t.sky; });
  return found == textures_.end() ? nullptr : &*found;
}

Power power(double exponent) {
  Power p;
  p.exponent = static_cast<float>(exponent);
  const double rounded = std::round(std::min(exponent, 1e9));  // from there on, it is all the same
  const bool whole = std::abs(rounded - exponent) < 1e-4 || exponent > 8;
  p.whole = whole ? static_cast<std::int32_t>(rounded) : -1;
  return p;
}

Material material_of(const render::Materials& materials, int id, const float* rgba, const render::Shape& shape,
                     const Textures& textures) {
  const render::Paint paint = render::paint_of(materials, id, rgba);
  Material material;
  material.rgb = three(paint.color.data());
  material.alpha = paint.color[3];
  for (int k = 0; k < 3; ++k) material.emission[k] = paint.emission * paint.color[k];
  material.specular = paint.specular;
  material.reflectance = paint.reflectance;
  material.shininess = power(128.0 * paint.shininess);
  material.texture = textures.find(paint.texture);
  if (material.texture != nullptr) {
    material.mapping = render::map_texture(materials, id, material.texture->cube, shape);
    if (material.mapping.kind == Mapping::kNone) material.texture = nullptr;
  }
  return material;
}

}  // namespace mimo::rays
