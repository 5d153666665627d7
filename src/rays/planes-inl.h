// Planes where their light is smooth, which is most of what an infant sees.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_PLANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_PLANES_INL_H
#undef MIMO_RAYS_PLANES_INL_H
#else
#define MIMO_RAYS_PLANES_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "rays/canvas-inl.h"
#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/lighting-inl.h"
#include "rays/sampling-inl.h"
#include "rays/smooth-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// Where the rays of a tile that lies wholly on a plane meet its flat texture.
class PlaneMap {
 public:
  PlaneMap(const Aspect& aspect, const Material& material, const Tile& tile)
      : aspect_(aspect),
        tile_(tile),
        x_(Set(aspect.o[0])),
        y_(Set(aspect.o[1])),
        height_(Set(0.0F - aspect.o[2])),
        scale_x_(Set(material.mapping.scale[0])),
        scale_y_(Set(material.mapping.scale[1])) {
    for (int k = 0; k < 3; ++k) {
      for (int column = 0; column < kTile; ++column) across_[k][column] = aspect.bx[k] * tile.x[column];
    }
  }

  void go_to_row(int row) {
    for (int k = 0; k < 3; ++k) base_[k] = aspect_.a[k] + aspect_.by[k] * tile_.y[row];
  }

  // 0..1: what is in front of the eye is at a finite place.
  HWY_INLINE void at(int column, V& u, V& v) const {
    const V t = height_ / (Set(base_[2]) + Load(across_[2] + column));
    u = Repeated((x_ + (Set(base_[0]) + Load(across_[0] + column)) * t) * scale_x_ - Set(0.5F));
    v = Repeated((y_ + (Set(base_[1]) + Load(across_[1] + column)) * t) * scale_y_ - Set(0.5F));
  }

 private:
  const Aspect& aspect_;
  const Tile& tile_;
  V x_, y_, height_, scale_x_, scale_y_;
  alignas(64) float across_[3][kTile];
  float base_[3];
};

// The taps of a tile's rays, of one mipmap a row. To aim at all and then to fetch all is faster than one after the
// other: the chains of instructions that wait for each other are half as long.
struct TapStore {
  alignas(64) std::uint32_t at[kRays];
  std::int32_t weights[kRays];
  std::int32_t mix[kRays];
  std::int32_t stride[kTile];

  HWY_INLINE void put(const Tap& tap, int i) {
    hn::Store(hn::BitCast(DU(), tap.upper), DU(), at + i);
    hn::Store(tap.weights, DI(), weights + i);
    hn::Store(tap.mix, DI(), mix + i);
  }
  HWY_INLINE Texel fetch(const std::uint32_t* texels, int i) const {
    const VI both = hn::Load(DI(), weights + i);
    return Mix(FetchRow(texels, at + i, both), FetchRow(texels + stride[i / kTile], at + i, both),
               hn::Load(DI(), mix + i));
  }
};

// A plane's texture at the rays of a tile: of all, or of those that met it.
class PlaneTexture {
 public:
  PlaneTexture(const Subject& subject, const Smooth& smooth, bool all)
      : subject_(subject), texture_(*MaterialOf(subject).texture), smooth_(smooth), all_(all) {
    PlaneMap map(subject.eye->aspects[subject.index], MaterialOf(subject), *subject.tile);
    const bool large = texture_.levels == 1 || smooth.level.most < 0;
    int level = kMixed;
    for (int row = 0; row < kTile; ++row) {
      map.go_to_row(row);
      level_[row] = large ? kLarge : level_of(row);
      if (level_[row] == kMixed) {
        keep(map, row);
        continue;
      }
      if (level_[row] != level) choose(level_[row]);
      level = level_[row];
      aim(map, row);
    }
  }

  HWY_INLINE Texel at(int row, int column) const {
    const std::uint32_t* const texels = subject_.frame->texels;
    const int i = row * kTile + column;
    if (level_[row] == kMixed) {
      return Filter<false>(texels, texture_, hn::Zero(DI()), Load(u_ + i), Load(v_ + i), wanted(row, column));
    }
    const Texel fine = fine_.fetch(texels, i);
    if (level_[row] == kLarge) return fine;
    return Mix(fine, coarse_.fetch(texels, i), hn::Load(DI(), mix_ + i));
  }

 private:
  static constexpr int kLarge = -1;  // no pixel spans more than a texel
  static constexpr int kMixed = -2;  // not all rays lie between the same mipmaps

  HWY_INLINE bool is_wanted(int i) const { return all_ || !None(Mine(subject_, i)); }
  HWY_INLINE V wanted(int row, int column) const { return At(smooth_.level, row, smooth_.across(column)); }

  // The finer of the mipmaps between which a row lies.
  int level_of(int row) const {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    const V top = Set(static_cast<float>(texture_.levels - 1));
    bool large = true;
    bool same = true;
    int first = 0;
    for (int column = 0; column < kTile; column += lanes) {
      const V level = wanted(row, column);
      large = large && All(hn::Le(level, Zero()));
      const VI below = Whole(hn::Floor(hn::Min(hn::Max(level, Zero()), top)));
      if (column == 0) first = hn::GetLane(below);
      same = same && hn::AllTrue(DI(), hn::Eq(below, SetI(first)));
    }
    return large ? kLarge : same ? first : kMixed;
  }

  void choose(int level) {
    const int fine = std::max(level, 0);
    const int coarse = std::min(fine + 1, texture_.levels - 1);
    fine_level_ = MipmapOf<false>(texture_, fine, hn::Zero(DI()));
    coarse_level_ = MipmapOf<false>(texture_, coarse, hn::Zero(DI()));
    fine_stride_ = std::max(texture_.width >> fine, 1) + 2;
    coarse_stride_ = std::max(texture_.width >> coarse, 1) + 2;
  }

  HWY_INLINE void keep(const PlaneMap& map, int row) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    for (int column = 0; column < kTile; column += lanes) {
      V u, v;
      map.at(column, u, v);
      Store(u, u_ + row * kTile + column);
      Store(v, v_ + row * kTile + column);
    }
  }

  HWY_INLINE void aim(const PlaneMap& map, int row) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    fine_.stride[row] = fine_stride_;
    coarse_.stride[row] = coarse_stride_;
    const V top = Set(static_cast<float>(texture_.levels - 1));
    for (int column = 0; column < kTile; column += lanes) {
      const int i = row * kTile + column;
      if (!is_wanted(i)) continue;
      V u, v;
      map.at(column, u, v);
      fine_.put(Aim(fine_level_, u, v), i);
      if (level_[row] == kLarge) continue;
      coarse_.put(Aim(coarse_level_, u, v), i);
      const V between = hn::Min(hn::Max(wanted(row, column), Zero()), top);
      hn::Store(Weight(between - hn::Floor(between)), DI(), mix_ + i);
    }
  }

  const Subject& subject_;
  const Texture& texture_;
  const Smooth& smooth_;
  const bool all_;
  Mipmap fine_level_, coarse_level_;
  int fine_stride_ = 0;
  int coarse_stride_ = 0;
  TapStore fine_, coarse_;
  alignas(64) std::int32_t mix_[kRays];
  alignas(64) float u_[kRays];
  float v_[kRays];
  int level_[kTile];
};

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
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const bool total =
      smooth.has_total && (subject.frame->lights.caster_count() == 0 || subject.shades[0].of_all == Shadows::kNone);
  for (int row = 0; row < kTile; ++row) {
    for (int column = 0; column < kTile; column += lanes) {
      const V light =
          total ? At(smooth.total, row, smooth.across(column)) : SmoothLightAt<true>(subject, smooth, row, column).x;
      hn::Store(Lighted(texture.at(row, column), LightWeight(light)), DI(),
                reinterpret_cast<std::int32_t*>(out) + row * kTile + column);
    }
  }
}

inline void PaintSmooth(const Subject& subject, const Smooth& smooth, Canvas& canvas) {
  const auto paint = [&](const PlaneTexture* texture) {
    (smooth.gray ? PaintSome<true> : PaintSome<false>)(subject, smooth, texture, canvas);
  };
  if (MaterialOf(subject).mapping.kind == Mapping::kNone) return paint(nullptr);
  const PlaneTexture texture(subject, smooth, false);
  paint(&texture);
}

// Of a tile that shows nothing else.
inline void PaintSmooth(const Subject& subject, const Smooth& smooth, std::uint32_t* out) {
  const auto paint = [&](const PlaneTexture* texture) {
    (smooth.gray ? PaintAll<true> : PaintAll<false>)(subject, smooth, texture, out);
  };
  if (MaterialOf(subject).mapping.kind == Mapping::kNone) return paint(nullptr);
  const PlaneTexture texture(subject, smooth, true);
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
