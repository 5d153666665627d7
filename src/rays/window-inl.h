// A tile of rays, and which part of it a solid may touch.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_WINDOW_INL_H
#undef MIMO_RAYS_WINDOW_INL_H
#else
#define MIMO_RAYS_WINDOW_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "rays/camera.h"
#include "rays/lanes-inl.h"
#include "rays/mesh-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

struct Strip;
struct Touching;

// The rays of one tile and what they meet.
struct Tile {
  Strip* strip;                // the tiles side by side that it is one of
  int place;                   // of its first column in that
  const Touching* row;         // what its row of tiles may touch
  alignas(64) float x[kTile];  // slopes
  alignas(64) float y[kTile];
  float dx, dy;
  bool parallel;                         // its rays are: x and y are places, m
  alignas(64) float t[kRays];            // depth of the nearest solid, kMiss for none
  alignas(64) std::int32_t id[kRays];    // its aspect, -1 for none
  alignas(64) std::int32_t face[kRays];  // its triangle, if it is a mesh
  alignas(64) std::int32_t away[kRays];  // if it is a mesh, the lights that are behind it there, a bit each
  float nearest, farthest;               // depths of what the tile shows; nearest > farthest if that is nothing
};

// The rows and columns of a tile that an aspect may touch; empty if first > last.
struct Window {
  int row0, row1, column0, column1;
};

// Slopes of rays of a tile, of which each has its own column or row.
HWY_INLINE V FindSlope(const float* slopes, VI i) {
  if constexpr (hn::MaxLanes(D()) == kTile) {
    return hn::TableLookupLanes(Load(slopes), hn::IndicesFromVec(D(), i));
  } else {
    return hn::GatherIndex(D(), slopes, i);
  }
}

// The rays of a tile in the frame of what an aspect shows; `across` is a + x bx + y by, see Eye.
HWY_INLINE Ray RayAcross(const Aspect& aspect, const Tile& tile, const V3& across) {
  if (tile.parallel) return {across, Set(aspect.o)};
  return {Set(aspect.o), across};
}

// The aspects of the camera that a row of tiles may touch, nearest first.
struct Touching {
  static constexpr int kMost = 512;  // where there are more, none is left out
  int count;
  bool all;
  std::int16_t index[kMost];

  HWY_INLINE int operator[](int k) const { return all ? k : index[k]; }
};

constexpr Window kNothing = {0, -1, 0, -1};

HWY_INLINE bool IsEmpty(const Window& w) { return w.row0 > w.row1 || w.column0 > w.column1; }

// Of what is no number: -1.
HWY_INLINE int Clamped(float v) { return static_cast<int>(std::min(std::max(-1.0F, v), kTile + 1.0F)); }

HWY_INLINE void FindRows(const Aspect& aspect, const Tile& tile, Window& w) {
  const float over = 1 / tile.dy;  // negative: rows go down
  w.row0 = std::max(Clamped((aspect.top - tile.y[0]) * over), 0);
  w.row1 = std::min(Clamped((aspect.bottom - tile.y[0]) * over + 1), kTile) - 1;
}

// What the row of tiles may touch that a tile is one of.
inline void FindTouching(const Eye& eye, const Tile& tile, Touching& touching) {
  touching.all = eye.count > Touching::kMost;
  touching.count = touching.all ? eye.count : 0;
  for (int k = 0; k < eye.count && !touching.all; ++k) {
    Window w;
    FindRows(eye.aspects[k], tile, w);
    if (w.row0 <= w.row1) touching.index[touching.count++] = static_cast<std::int16_t>(k);
  }
}

HWY_INLINE Window WindowOf(const Aspect& aspect, const Tile& tile) {
  // The least of facing over the tile; rays beyond the last are close enough.
  const float far_x = tile.x[0] + tile.dx * kTile;
  const float far_y = tile.y[0] + tile.dy * kTile;
  const float least = aspect.facing[0] + std::min(aspect.facing[1] * tile.x[0], aspect.facing[1] * far_x) +
                      std::min(aspect.facing[2] * tile.y[0], aspect.facing[2] * far_y);
  if (least > 0) return kNothing;
  const float over_x = 1 / tile.dx;
  Window w;
  w.column0 = std::max(Clamped((aspect.left - tile.x[0]) * over_x), 0);
  w.column1 = std::min(Clamped((aspect.right - tile.x[0]) * over_x + 1), kTile) - 1;
  FindRows(aspect, tile, w);
  return w;
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
