// Planes where their light is smooth, which is most of what an infant sees.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_PLANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_PLANES_INL_H
#undef MIMO_RAYS_PLANES_INL_H
#else
#define MIMO_RAYS_PLANES_INL_H
#endif

#include <algorithm>
#include <array>
#include <cstdint>

#include "rays/canvas-inl.h"
#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/lighting-inl.h"
#include "rays/sampling-inl.h"
#include "rays/smooth-inl.h"
#include "rays/tile-inl.h"
#include "rays/tile_texture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// Where the rays of a tile that lies wholly on a plane meet its flat texture.
class PlaneMap {
 public:
  static constexpr bool kCube = false;

  PlaneMap(const Aspect& aspect, const Material& material, const Tile& tile, const Smooth& smooth)
      : aspect_(aspect),
        tile_(tile),
        smooth_(smooth),
        scale_x_(material.mapping.scale[0]),
        scale_y_(material.mapping.scale[1]),
        origin_x_(material.mapping.origin[0]),
        origin_y_(material.mapping.origin[1]) {
    for (int k = 0; k < 3; ++k) {
      for (int column = 0; column < kTile; ++column) across_[k][column] = aspect.bx[k] * tile.x[column];
    }
  }

  int face() const { return 0; }
  bool is_large() const { return smooth_.level.most < 0; }

  class Row {
   public:
    Row(const PlaneMap& map, int row) : map_(map), row_(row) {
      for (int k = 0; k < 3; ++k) base_[k] = map.aspect_.a[k] + map.aspect_.by[k] * map.tile_.y[row];
    }

    // 0..1: what is in front of the eye is at a finite place.
    HWY_INLINE void at(int column, V& u, V& v) const {
      const std::array<float, 3>& o = map_.aspect_.o;
      const V t = Set(0.0F - o[2]) / along(2, column);
      u = Repeated((Set(o[0]) + along(0, column) * t) * Set(map_.scale_x_) + Set(map_.origin_x_));
      v = Repeated((Set(o[1]) + along(1, column) * t) * Set(map_.scale_y_) + Set(map_.origin_y_));
    }
    HWY_INLINE V level(int column) const { return At(map_.smooth_.level, row_, map_.smooth_.across(column)); }

   private:
    HWY_INLINE V along(int k, int column) const { return Set(base_[k]) + Load(map_.across_[k] + column); }

    const PlaneMap& map_;
    const int row_;
    float base_[3];
  };

 private:
  const Aspect& aspect_;
  const Tile& tile_;
  const Smooth& smooth_;
  const float scale_x_, scale_y_, origin_x_, origin_y_;
  alignas(64) float across_[3][kTile];
};

using PlaneTexture = TileTexture<PlaneMap>;

// The light of a plane, with the shadows of each ray.
template <bool kGray>
HWY_INLINE V3 SmoothLightAt(const Subject& subject, const Smooth& smooth, int row, int column) {
  const V x = smooth.across(column);
  V3 color = ColorAt<kGray>(smooth.color, row, x);
  for (int k = 0; k < subject.frame->lights.caster_count(); ++k) {
    if (!smooth.reached[k] || subject.shades[k].of_all == Shadows::kAll) continue;
    color = color + ColorAt<kGray>(smooth.extra[k], row, x) * LitAt(subject.shades[k], row * kTile + column);
  }
  return color;
}

// Those rays that met the plane.
template <bool kGray>
HWY_NOINLINE void PaintSome(const Subject& subject, const Smooth& smooth, const PlaneTexture* texture, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int i = 0; i < kRays; i += lanes) {
    const M mine = Mine(subject, i);
    if (None(mine)) continue;
    V3 color = SmoothLightAt<kGray>(subject, smooth, i / kTile, i % kTile);
    if (texture != nullptr) color = AtMostWhite(color * Unpacked(texture->at(i / kTile, i % kTile)));
    Put<Brush::kPut>(color, mine, 1.0F, i, canvas);
  }
}

// All rays of a tile, as Packed() gives them.
template <bool kGray>
HWY_NOINLINE void PaintAll(const Subject& subject, const Smooth& smooth, const PlaneTexture* texture,
                           std::uint32_t* out) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int i = 0; i < kRays; i += lanes) {
    V3 color = SmoothLightAt<kGray>(subject, smooth, i / kTile, i % kTile);
    if (texture != nullptr) color = color * Unpacked(texture->at(i / kTile, i % kTile));
    hn::Store(Packed(AtMostWhite(color)), DI(), reinterpret_cast<std::int32_t*>(out) + i);
  }
}

// The same of a texture in grey light of at most kBrightest, to a twentieth of a level.
HWY_NOINLINE void PaintAllGray(const Subject& subject, const Smooth& smooth, const PlaneTexture& texture,
                               std::uint32_t* out) {
  const bool total =
      smooth.has_total && (subject.frame->lights.caster_count() == 0 || subject.shades[0].of_all == Shadows::kNone);
  texture.each([&](int i, const Texel& texel) {
    const int row = i / kTile;
    const int column = i % kTile;
    const V light =
        total ? At(smooth.total, row, smooth.across(column)) : SmoothLightAt<true>(subject, smooth, row, column).x;
    hn::Store(Lighted(texel, LightWeight(light)), DI(), reinterpret_cast<std::int32_t*>(out) + i);
  });
}

inline void PaintSmooth(const Subject& subject, const Smooth& smooth, Canvas& canvas) {
  const auto paint = [&](const PlaneTexture* texture) {
    (smooth.gray ? PaintSome<true> : PaintSome<false>)(subject, smooth, texture, canvas);
  };
  if (MaterialOf(subject).mapping.kind == Mapping::kNone) return paint(nullptr);
  const PlaneMap map(subject.eye->aspects[subject.index], MaterialOf(subject), *subject.tile, smooth);
  const PlaneTexture texture(subject.frame->texels, *MaterialOf(subject).texture, map, subject.id, subject.index);
  paint(&texture);
}

// Of a tile that shows nothing else.
inline void PaintSmooth(const Subject& subject, const Smooth& smooth, std::uint32_t* out) {
  const auto paint = [&](const PlaneTexture* texture) {
    (smooth.gray ? PaintAll<true> : PaintAll<false>)(subject, smooth, texture, out);
  };
  if (MaterialOf(subject).mapping.kind == Mapping::kNone) return paint(nullptr);
  const PlaneMap map(subject.eye->aspects[subject.index], MaterialOf(subject), *subject.tile, smooth);
  const PlaneTexture texture(subject.frame->texels, *MaterialOf(subject).texture, map, nullptr, 0);
  if (smooth.gray && subject.frame->lights.caster_count() < 2) {
    PaintAllGray(subject, smooth, texture, out);
  } else {
    paint(&texture);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
