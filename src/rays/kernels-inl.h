// The kernels for one instruction set: the parts of the renderer that work on vectors of rays (*-inl.h). kernels.cpp
// includes this file for the baseline; CMake writes one more source for each better set, which it names MIMO_KERNELS,
// so that compilers work side by side and none needs much memory.
//
// Highway gives a set its instructions by pragmas, not by compiler options: what is inline elsewhere (the standard
// library's functions) must not be compiled for a processor that may not be there. Its loop over the sets includes this
// file again.
//
// Nothing here is fused or approximated by the hardware: sums, products, quotients and roots are IEEE's, so that all
// paths give the same picture, bit by bit.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "rays/kernels.h"

#define HWY_IS_DEBUG_BUILD 0
// No more than the set and the baseline, which comes last: the parts' include guards count the loop's turns.
#ifdef MIMO_KERNELS
#define HWY_DISABLED_TARGETS (~(MIMO_KERNELS | HWY_BASELINE_TARGETS))
#else
#define HWY_DISABLED_TARGETS (~HWY_BASELINE_TARGETS)
#define MIMO_KERNELS HWY_STATIC_TARGET
#define MIMO_KERNELS_OF_BASELINE
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rays/kernels-inl.h"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET == MIMO_KERNELS && (MIMO_KERNELS != HWY_STATIC_TARGET || defined(MIMO_KERNELS_OF_BASELINE))

#ifdef MIMO_WATCHED_KERNELS  // what the compiler may call compiles in a tenth of the time
#undef HWY_INLINE
#define HWY_INLINE inline
#endif

#include "rays/coloring-inl.h"
#include "rays/lanes-inl.h"
#include "rays/plain-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

HWY_INLINE std::uint32_t Average(const std::uint32_t* color, int samples) {
  std::uint32_t sum[3] = {0, 0, 0};
  for (int row = 0; row < samples; ++row) {
    for (int column = 0; column < samples; ++column) {
      const std::uint32_t c = color[row * kTile + column];
      for (int k = 0; k < 3; ++k) sum[k] += (c >> (8 * k)) & 255U;
    }
  }
  const std::uint32_t count = static_cast<std::uint32_t>(samples * samples);
  std::uint32_t mean = 0;
  for (int k = 0; k < 3; ++k) mean |= ((sum[k] + count / 2) / count) << (8 * k);
  return mean;
}

// Leaves out every fourth byte. What is written too much is overwritten next, and the last pixel writes none.
HWY_INLINE void PackOneByOne(const std::uint32_t* from, int count, std::uint8_t* to) {
  for (int k = 0; k + 1 < count; ++k) std::memcpy(to + 3 * k, from + k, 4);
  if (count > 0) std::memcpy(to + 3 * (count - 1), from + count - 1, 3);
}

#if HWY_TARGET != HWY_SCALAR
// Sixteen pixels: 48 bytes.
HWY_INLINE void PackTile(const std::uint32_t* from, std::uint8_t* to) {
  const hn::Full128<std::uint8_t> d;
  alignas(16) static constexpr std::uint8_t kInLower[16] = {0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15};
  alignas(16) static constexpr std::uint8_t kInUpper[16] = {3, 7, 11, 15, 0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14};
  const auto four = [&](int k, const std::uint8_t* order) {  // in the lower or the upper twelve bytes
    const auto pixels = hn::BitCast(d, hn::Load(hn::Full128<std::uint32_t>(), from + 4 * k));
    return hn::TableLookupBytes(pixels, hn::Load(d, order));
  };
  hn::StoreU(hn::CombineShiftRightBytes<4>(d, four(1, kInLower), four(0, kInUpper)), d, to);
  hn::StoreU(hn::CombineShiftRightBytes<8>(d, four(2, kInLower), four(1, kInUpper)), d, to + 16);
  hn::StoreU(hn::CombineShiftRightBytes<12>(d, four(3, kInLower), four(2, kInUpper)), d, to + 32);
}
#endif

HWY_INLINE void Pack(const std::uint32_t* from, int count, std::uint8_t* to) {
#if HWY_TARGET != HWY_SCALAR
  if (count == kTile) return PackTile(from, to);
#endif
  PackOneByOne(from, count, to);
}

void WriteColor(const Grid& grid, int tile_row, int tile_column, const std::uint32_t* color) {
  const int n = grid.samples;
  const int size = kTile / n;
  const int width = std::min(size, grid.width - tile_column * size);
  const int height = std::min(size, grid.height - tile_row * size);
  for (int row = 0; row < height; ++row) {
    std::uint8_t* to =
        grid.rgb + static_cast<std::size_t>(tile_row * size + row) * grid.rgb_row + 3 * (tile_column * size);
    const std::uint32_t* from = color + row * n * kTile;
    if (n == 1) {
      Pack(from, width, to);
    } else {
      for (int column = 0; column < width; ++column) {
        const std::uint32_t mean = Average(from + column * n, n);
        std::memcpy(to + 3 * column, &mean, 3);
      }
    }
  }
}

// The far plane where rays meet nothing before it.
void WriteDepths(const Grid& grid, int tile_row, int tile_column, const Tile& tile) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V end = Set(grid.frame->camera.far_plane);
  const int width = std::min(kTile, grid.columns - tile_column * kTile);
  const int height = std::min(kTile, grid.rows - tile_row * kTile);
  for (int row = 0; row < height; ++row) {
    float* to = grid.depth + static_cast<std::size_t>(tile_row * kTile + row) * grid.depth_row + tile_column * kTile;
    alignas(64) float depths[kTile];
    for (int column = 0; column < kTile; column += lanes) {
      Store(hn::Min(Load(tile.t + row * kTile + column), end), depths + column);
    }
    std::memcpy(to, depths, static_cast<std::size_t>(width) * sizeof(float));
  }
}

void WriteSegments(const Grid& grid, int tile_row, int tile_column, const Tile& tile) {
  const Frame& frame = *grid.frame;
  const int width = std::min(kTile, grid.columns - tile_column * kTile);
  const int height = std::min(kTile, grid.rows - tile_row * kTile);
  for (int row = 0; row < height; ++row) {
    std::int32_t* to = grid.segmentation + static_cast<std::size_t>(tile_row * kTile + row) * grid.segmentation_row +
                       tile_column * kTile;
    for (int column = 0; column < width; ++column) {
      const int i = row * kTile + column;
      const bool hit = tile.id[i] >= 0 && tile.t[i] <= frame.camera.far_plane;
      to[column] = hit ? frame.solids[frame.camera.aspects[tile.id[i]].solid].id : -1;
    }
  }
}

// Colours alone, where that is simple.
bool ColorPlainTile(const Frame& frame, Tile& tile, std::uint32_t* color) {
  const int only = OnlyAspect(frame.camera, tile);
  if (only == kSeveral) return false;
  if (only == kNone) return ColorSky(frame.backdrop, frame.texels, tile, color);
  return ColorPlane(frame, only, tile, color);
}

void DrawOneTile(const Grid& grid, int tile_row, int tile_column, Tile& tile) {
  const Frame& frame = *grid.frame;
  const bool shapes = grid.depth != nullptr || grid.segmentation != nullptr;
  alignas(64) std::uint32_t color[kRays];
  const bool plain = grid.rgb != nullptr && ColorPlainTile(frame, tile, color);
  if (plain) WriteColor(grid, tile_row, tile_column, color);
  if (plain && !shapes) return;
  StartTile(frame.solids, tile);
  for (int i = 0; i < tile.row->count; ++i) {
    const int k = (*tile.row)[i];
    if (!frame.solids[frame.camera.aspects[k].solid].transparent) Meet(frame.solids, frame.camera, k, tile);
  }
  if (grid.rgb != nullptr && !plain) {
    FindDepths(tile);
    ColorTile(frame, tile, color);
    WriteColor(grid, tile_row, tile_column, color);
  }
  if (!shapes) return;
  for (int k = 0; k < frame.camera.transparent_count; ++k)
    Meet(frame.solids, frame.camera, frame.camera.transparent[k], tile);
  if (grid.depth != nullptr) WriteDepths(grid, tile_row, tile_column, tile);
  if (grid.segmentation != nullptr) WriteSegments(grid, tile_row, tile_column, tile);
}

// As many tiles side by side as 0.15 radians hold.
int TilesOfStrip(const Grid& grid) {
  int tiles = kMostTiles;
  while (tiles > 1 && static_cast<float>(tiles * kTile) * grid.dx > 0.15F) tiles /= 2;
  return tiles;
}

void DrawRow(const Grid& grid, int row) {
  const auto x = [&grid](int column) { return grid.x + static_cast<float>(column) * grid.dx; };
  const int tiles = TilesOfStrip(grid);
  Strip strip;
  Tile tile;
  tile.strip = &strip;
  tile.dx = grid.dx;
  tile.dy = grid.dy;
  tile.parallel = grid.frame->camera.rays == Rays::kParallel;
  for (int k = 0; k < kTile; ++k) tile.y[k] = grid.y + static_cast<float>(row * kTile + k) * grid.dy;
  Touching touching;
  FindTouching(grid.frame->camera, tile, touching);
  tile.row = &touching;
  for (int column = 0; column < grid.tile_columns(); ++column) {
    const int place = column % tiles;
    if (place == 0) strip.start({x(column * kTile), tile.y[0], tiles * kTile});
    tile.place = place * kTile;
    for (int k = 0; k < kTile; ++k) tile.x[k] = x(column * kTile + k);
    DrawOneTile(grid, row, column, tile);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
