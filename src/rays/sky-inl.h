// Tiles in which all that is seen of the sky lies on one face of its cube.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_SKY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_SKY_INL_H
#undef MIMO_RAYS_SKY_INL_H
#else
#define MIMO_RAYS_SKY_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "rays/backdrop.h"
#include "rays/canvas-inl.h"
#include "rays/lanes-inl.h"
#include "rays/sampling-inl.h"
#include "rays/tile-inl.h"
#include "rays/tile_texture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

constexpr float kHair = 1e-4F;  // by which all is decided as it would be for each ray

// A number that is linear in the slopes, at the corners of a tile.
struct Corners {
  float value[4];

  Corners(const Tile& tile, float a, float bx, float by) {
    for (int k = 0; k < 4; ++k) value[k] = a + by * tile.y[k & 2 ? kTile - 1 : 0] + bx * tile.x[k & 1 ? kTile - 1 : 0];
  }
  float least() const { return *std::min_element(value, value + 4); }
  float most() const { return *std::max_element(value, value + 4); }
};

// One face of a cube texture, seen by all rays of a tile: its number, and the components of their directions.
struct Face {
  int number;
  int major, across, down;
  float major_sign, across_sign, down_sign;
};

// The face of the sky's cube on which all of a tile lies; false if it lies on several.
inline bool FindFace(const Corners (&direction)[3], Face& face) {
  const auto is_major = [&](int k) {
    const float least = std::min(std::abs(direction[k].least()), std::abs(direction[k].most()));
    if (direction[k].least() <= 0 && direction[k].most() >= 0) return false;
    return std::all_of(direction, direction + 3, [&](const Corners& other) {
      return &other == &direction[k] || std::max(-other.least(), other.most()) * (1 + kHair) < least;
    });
  };
  for (int k = 0; k < 3; ++k) {
    if (!is_major(k)) continue;
    const float sign = direction[k].least() > 0 ? 1.0F : -1.0F;
    const int number = 2 * k + (sign < 0 ? 1 : 0);
    if (k == 0) face = {number, 0, 2, 1, sign, -sign, -1};
    if (k == 1) face = {number, 1, 0, 2, sign, 1, sign};
    if (k == 2) face = {number, 2, 0, 1, sign, sign, -1};
    return true;
  }
  return false;
}

// Where the rays of a tile meet the one face of the sky on which all of it lies.
class SkyMap {
  struct Linear {
    float a, bx, by;
  };

 public:
  static constexpr bool kCube = true;

  SkyMap(const Sky& sky, const Tile& tile, const Face& face, const Corners& major)
      : tile_(tile), face_(face.number), width_(static_cast<float>(sky.texture->width)), step_(tile.dx * sky.step) {
    const auto component = [&](int k, float sign) {
      return Linear{sign * sky.a[k], sign * sky.bx[k], sign * sky.by[k]};
    };
    major_ = component(face.major, face.major_sign);
    across_ = component(face.across, face.across_sign);
    down_ = component(face.down, face.down_sign);
    const float spread = step_ * 0.5F * width_ / std::min(std::abs(major.least()), std::abs(major.most()));
    is_large_ = spread < 1 - kHair;
  }

  int face() const { return face_; }
  bool is_large() const { return is_large_; }

  class Row {
   public:
    Row(const SkyMap& map, int row) : map_(map), y_(map.tile_.y[row]) {}

    HWY_INLINE void at(int column, V& u, V& v) const {
      const V scale = scale_at(column);
      u = along(map_.across_, column) * scale + Set(0.5F);
      v = along(map_.down_, column) * scale + Set(0.5F);
    }
    // The sky's map is turned but not scaled: from pixel to pixel, its direction changes as the ray does.
    HWY_INLINE V level(int column) const {
      const V each = scale_at(column) * Set(map_.step_ * map_.width_);
      return LevelOf(each * each);
    }

   private:
    HWY_INLINE V along(const Linear& of, int column) const {
      return Set(of.a + of.by * y_) + Set(of.bx) * Load(map_.tile_.x + column);
    }
    HWY_INLINE V scale_at(int column) const { return Set(0.5F) / along(map_.major_, column); }

    const SkyMap& map_;
    const float y_;
  };

 private:
  const Tile& tile_;
  const int face_;
  const float width_, step_;
  bool is_large_;
  Linear major_, across_, down_;  // of the direction in which a ray goes
};

using SkyTexture = TileTexture<SkyMap>;

// Calls paint(texture) with the sky at the rays of a tile, or at those that `id` gives -1; false, and nothing is
// painted, where not all of the tile lies on one face.
template <class Paint>
HWY_INLINE bool PaintOneFace(const Sky& sky, const std::uint32_t* texels, const Tile& tile, const std::int32_t* id,
                             const Paint& paint) {
  const Corners direction[3] = {Corners(tile, sky.a[0], sky.bx[0], sky.by[0]),
                                Corners(tile, sky.a[1], sky.bx[1], sky.by[1]),
                                Corners(tile, sky.a[2], sky.bx[2], sky.by[2])};
  Face face;
  if (!FindFace(direction, face)) return false;
  const SkyMap map(sky, tile, face, direction[face.major]);
  paint(SkyTexture(texels, *sky.texture, map, id, -1));
  return true;
}

// Colours a tile that shows nothing but one face of the sky.
inline bool ColorSky(const Backdrop& backdrop, const std::uint32_t* texels, const Tile& tile, std::uint32_t* out) {
  const Sky& sky = backdrop.sky;
  if (sky.texture == nullptr || backdrop.fog.shown) return false;
  const Haze& haze = backdrop.haze;
  if (haze.shown && Corners(tile, haze.a[2], haze.bx[2], haze.by[2]).least() < kHair) return false;
  return PaintOneFace(sky, texels, tile, nullptr, [out](const SkyTexture& texture) {
    texture.each([out](int i, const Texel& texel) {
      hn::Store(Unlighted(texel), DI(), reinterpret_cast<std::int32_t*>(out) + i);
    });
  });
}

// The rays of a tile that meet nothing, if all of it lies on one face of a sky without fog.
inline bool PaintSkyFace(const Sky& sky, const std::uint32_t* texels, const Tile& tile, const std::int32_t* id,
                         Canvas& canvas) {
  return PaintOneFace(sky, texels, tile, id, [&](const SkyTexture& texture) {
    for (int i = 0; i < kRays; i += static_cast<int>(hn::Lanes(D()))) {
      const M empty = hn::RebindMask(D(), hn::Lt(hn::Load(DI(), id + i), hn::Zero(DI())));
      if (!None(empty)) Put<Brush::kPut>(Unpacked(texture.at(i / kTile, i % kTile)), empty, 1.0F, i, canvas);
    }
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
