// The part that runs once for each vector of rays, compiled for several instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mimo::rays {

// What the kernels are asked for.

struct Frame;

constexpr int kTile = 16;  // a tile is kTile x kTile rays

// A picture to be drawn, as a grid of rays: ray (column, row) has the slopes x + column * dx, y + row * dy.
struct Grid {
  const Frame* frame = nullptr;
  int columns = 0, rows = 0;  // of rays: the picture's times `samples`
  float x = 0, y = 0, dx = 0, dy = 0;
  int samples = 1;            // rays a pixel along each axis; divides kTile
  int width = 0, height = 0;  // of the picture
  std::uint8_t* rgb = nullptr;
  float* depth = nullptr;                // only with one sample a pixel
  std::int32_t* segmentation = nullptr;  // likewise
  // From one row of the picture to the next: bytes, and numbers.
  std::size_t rgb_row = 0, depth_row = 0, segmentation_row = 0;

  int tile_columns() const { return (columns + kTile - 1) / kTile; }
  int tile_rows() const { return (rows + kTile - 1) / kTile; }
};

// Draws a row of tiles.
using DrawRow = void (*)(const Grid& grid, int row);

struct Path {
  const char* name;
  DrawRow draw;
};

// What this build has for this machine, best first; never empty.
std::vector<Path> paths();

}  // namespace mimo::rays
