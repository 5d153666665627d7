// The colours of a texture at the rays of a tile.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_TILE_TEXTURE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_TILE_TEXTURE_INL_H
#undef MIMO_RAYS_TILE_TEXTURE_INL_H
#else
#define MIMO_RAYS_TILE_TEXTURE_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "rays/lanes-inl.h"
#include "rays/materials.h"
#include "rays/sampling-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

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

// A texture at the rays of a tile: of all, or of those that `id` gives this index. A map says where the rays meet it:
//   kCube, face()           whether it is a cube's, and which face of it
//   is_large()              whether no pixel spans more than a texel
//   Row(map, row)           of whose rays
//     at(column, u, v)      is the place, 0..1
//     level(column)         and the mipmap that is wanted
template <class Map>
class TileTexture {
 public:
  TileTexture(const std::uint32_t* texels, const Texture& texture, const Map& map, const std::int32_t* id, int index)
      : texels_(texels), texture_(texture), face_(SetI(map.face())), id_(id), index_(index) {
    if (texture.levels == 1 || map.is_large()) {
      std::fill_n(row_level_, kTile, kLarge);
    } else {
      find_levels(map);
    }
    for (int row = 0; row < kTile;) {
      int end = row + 1;
      while (end < kTile && row_level_[end] == row_level_[row]) ++end;
      row_level_[row] == kMixed ? keep(map, row, end) : aim(map, row, end);
      row = end;
    }
  }

  // put(i, texel) of all rays.
  template <class Put>
  HWY_INLINE void each(const Put& put) const {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    for (int row = 0; row < kTile;) {
      const int level = row_level_[row];
      int end = row + 1;
      while (end < kTile && row_level_[end] == level) ++end;
      if (level == kLarge) {
        for (int i = row * kTile; i < end * kTile; i += lanes) put(i, fine_.fetch(texels_, i));
      } else if (level == kMixed) {
        for (int i = row * kTile; i < end * kTile; i += lanes) put(i, mixed(i));
      } else {
        for (int i = row * kTile; i < end * kTile; i += lanes) {
          put(i, Mix(fine_.fetch(texels_, i), coarse_.fetch(texels_, i), hn::Load(DI(), mix_ + i)));
        }
      }
      row = end;
    }
  }

  HWY_INLINE Texel at(int row, int column) const {
    const int i = row * kTile + column;
    if (row_level_[row] == kMixed) return mixed(i);
    const Texel fine = fine_.fetch(texels_, i);
    if (row_level_[row] == kLarge) return fine;
    return Mix(fine, coarse_.fetch(texels_, i), hn::Load(DI(), mix_ + i));
  }

 private:
  static constexpr int kLarge = -1;  // no pixel spans more than a texel
  static constexpr int kMixed = -2;  // not all rays lie between the same mipmaps

  HWY_INLINE bool is_wanted(int i) const {
    return id_ == nullptr || !hn::AllFalse(DI(), hn::Eq(hn::Load(DI(), id_ + i), SetI(index_)));
  }

  // (Not inlined: it would take the registers of what is usual.)
  HWY_NOINLINE Texel mixed(int i) const {
    return Filter<Map::kCube>(texels_, texture_, face_, Load(u_ + i), Load(v_ + i), Load(level_ + i));
  }

  // Of each row, the finer of the mipmaps between which it lies.
  void find_levels(const Map& map) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    const V top = Set(static_cast<float>(texture_.levels - 1));
    for (int row = 0; row < kTile; ++row) {
      const typename Map::Row rays(map, row);
      bool large = true;
      bool same = true;
      int first = 0;
      for (int column = 0; column < kTile; column += lanes) {
        const V level = rays.level(column);
        Store(level, level_ + row * kTile + column);
        large = large && All(hn::Le(level, Zero()));
        const VI below = Whole(hn::Floor(hn::Min(hn::Max(level, Zero()), top)));
        if (column == 0) first = hn::GetLane(below);
        same = same && hn::AllTrue(DI(), hn::Eq(below, SetI(first)));
      }
      row_level_[row] = large ? kLarge : same ? first : kMixed;
    }
  }

  // Rows that do not lie between two mipmaps only.
  void keep(const Map& map, int row, int end) {
    for (; row < end; ++row) {
      const typename Map::Row rays(map, row);
      for (int column = 0; column < kTile; column += static_cast<int>(hn::Lanes(D()))) {
        V u, v;
        rays.at(column, u, v);
        Store(u, u_ + row * kTile + column);
        Store(v, v_ + row * kTile + column);
      }
    }
  }

  // Rows of the same level.
  void aim(const Map& map, int row, int end) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    const bool large = row_level_[row] == kLarge;
    const int fine = std::max(row_level_[row], 0);
    const int coarse = std::min(fine + 1, texture_.levels - 1);
    const Mipmap finer = MipmapOf<Map::kCube>(texture_, fine, face_);
    const Mipmap coarser = MipmapOf<Map::kCube>(texture_, coarse, face_);
    const V top = Set(static_cast<float>(texture_.levels - 1));
    std::fill(fine_.stride + row, fine_.stride + end, std::max(texture_.width >> fine, 1) + 2);
    std::fill(coarse_.stride + row, coarse_.stride + end, std::max(texture_.width >> coarse, 1) + 2);
    for (; row < end; ++row) {
      const typename Map::Row rays(map, row);
      for (int column = 0; column < kTile; column += lanes) {
        const int i = row * kTile + column;
        if (!is_wanted(i)) continue;
        V u, v;
        rays.at(column, u, v);
        fine_.put(Aim(finer, u, v), i);
        if (large) continue;
        coarse_.put(Aim(coarser, u, v), i);
        const V between = hn::Min(hn::Max(Load(level_ + i), Zero()), top);
        hn::Store(Weight(between - hn::Floor(between)), DI(), mix_ + i);
      }
    }
  }

  const std::uint32_t* const texels_;
  const Texture& texture_;
  const VI face_;
  const std::int32_t* const id_;
  const int index_;
  TapStore fine_, coarse_;
  alignas(64) std::int32_t mix_[kRays];
  alignas(64) float level_[kRays];
  float u_[kRays];
  float v_[kRays];
  int row_level_[kTile];
};

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
