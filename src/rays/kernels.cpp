// Compiled once for each instruction set: foreach_target includes this file again and again, and it the parts of the
// renderer that work on vectors of rays (*-inl.h).
//
// Nothing here is fused or approximated by the hardware: sums, products, quotients and roots are IEEE's, so that all
// paths give the same picture, bit by bit.
#include "rays/kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#define HWY_IS_DEBUG_BUILD 0
// The vectors below are members of structs, which scalable vectors cannot be; of the x86 sets, these are enough. Sets
// that are better than AVX3 have lower bits.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | (HWY_AVX3 - 1))
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rays/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifdef MIMO_WATCHED_KERNELS  // what the compiler may call compiles in a tenth of the time
#undef HWY_INLINE
#define HWY_INLINE inline
#endif

#include "base/processor.h"
#include "rays/coloring-inl.h"
#include "rays/lanes-inl.h"
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
  std::memcpy(to + 3 * (count - 1), from + count - 1, 3);
}

HWY_INLINE void Pack(const std::uint32_t* from, int count, std::uint8_t* to) {
  int done = 0;
#if HWY_TARGET != HWY_SCALAR
  const hn::Full128<std::uint8_t> d;
  alignas(16) static constexpr std::uint8_t kOrder[16] = {0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15};
  const auto order = hn::Load(d, kOrder);
  for (; done + 8 <= count; done += 4) {
    const auto four = hn::Load(hn::Full128<std::uint32_t>(), from + done);
    hn::StoreU(hn::TableLookupBytes(hn::BitCast(d, four), order), d, to + 3 * done);
  }
#endif
  PackOneByOne(from + done, count - done, to + 3 * done);
}

void WriteColor(const Grid& grid, int tile_row, int tile_column, const std::uint32_t* color) {
  const int n = grid.samples;
  const int size = kTile / n;
  const int width = std::min(size, grid.width - tile_column * size);
  const int height = std::min(size, grid.height - tile_row * size);
  for (int row = 0; row < height; ++row) {
    std::uint8_t* to =
        grid.rgb + 3 * (static_cast<std::size_t>(tile_row * size + row) * grid.width + tile_column * size);
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

// Where the rays of a tile meet the solid that one of the camera's aspects shows.
void Meet(const Solids& solids, const Camera& camera, int index, Tile& tile) {
  const Window w = WindowOf(camera.aspects[index], tile);
  if (!IsEmpty(w)) Cast<false>(solids, camera, index, tile, w, &camera.near_plane, tile.t, tile.id, tile.face);
}

void WriteShapes(const Grid& grid, int tile_row, int tile_column, const Tile& tile) {
  const Frame& frame = *grid.frame;
  const int width = std::min(kTile, grid.columns - tile_column * kTile);
  const int height = std::min(kTile, grid.rows - tile_row * kTile);
  for (int row = 0; row < height; ++row) {
    const std::size_t start = static_cast<std::size_t>(tile_row * kTile + row) * grid.columns + tile_column * kTile;
    for (int column = 0; column < width; ++column) {
      const int i = row * kTile + column;
      const bool hit = tile.id[i] >= 0 && tile.t[i] <= frame.camera.far_plane;
      if (grid.depth != nullptr) grid.depth[start + column] = hit ? tile.t[i] : frame.camera.far_plane;
      if (grid.segmentation != nullptr) {
        grid.segmentation[start + column] = hit ? frame.solids[frame.camera.aspects[tile.id[i]].solid].id : -1;
      }
    }
  }
}

void DrawOneTile(const Grid& grid, int index) {
  const Frame& frame = *grid.frame;
  const int tile_row = index / grid.tile_columns();
  const int tile_column = index % grid.tile_columns();
  Tile tile;
  tile.dx = grid.dx;
  tile.dy = grid.dy;
  for (int k = 0; k < kTile; ++k) {
    tile.x[k] = grid.x + static_cast<float>(tile_column * kTile + k) * grid.dx;
    tile.y[k] = grid.y + static_cast<float>(tile_row * kTile + k) * grid.dy;
  }
  std::fill_n(tile.t, kRays, kMiss);
  std::fill_n(tile.id, kRays, -1);
  if (frame.solids.meshes()) std::fill_n(tile.face, kRays, 0);
  for (int k = 0; k < frame.camera.count; ++k) {
    if (!frame.solids[frame.camera.aspects[k].solid].transparent) Meet(frame.solids, frame.camera, k, tile);
  }
  if (grid.rgb != nullptr) {
    FindDepths(tile);
    alignas(64) std::uint32_t color[kRays];
    ColorTile(frame, tile, color);
    WriteColor(grid, tile_row, tile_column, color);
  }
  if (grid.depth == nullptr && grid.segmentation == nullptr) return;
  for (int k = 0; k < frame.camera.transparent_count; ++k)
    Meet(frame.solids, frame.camera, frame.camera.transparent[k], tile);
  WriteShapes(grid, tile_row, tile_column, tile);
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mimo::rays {

std::vector<Path> paths() {
  std::vector<Path> result;
#if HWY_ARCH_X86
#if HWY_TARGETS & HWY_AVX3
  if (has_avx512()) result.push_back({"AVX3", &N_AVX3::DrawOneTile});
#endif
#if HWY_TARGETS & HWY_AVX2
  if (has_avx2()) result.push_back({"AVX2", &N_AVX2::DrawOneTile});
#endif
#if HWY_TARGETS & HWY_SSE4
  if (has_sse4()) result.push_back({"SSE4", &N_SSE4::DrawOneTile});
#endif
#endif
  // What the compiler may assume of every machine that this build is for.
  const char* const baseline = HWY_STATIC_TARGET == HWY_EMU128 ? "portable" : hwy::TargetName(HWY_STATIC_TARGET);
  if (result.empty() || std::strcmp(result.back().name, baseline) != 0) {
    result.push_back({baseline, &HWY_STATIC_DISPATCH(DrawOneTile)});
  }
  return result;
}

}  // namespace mimo::rays

#endif  // HWY_ONCE
