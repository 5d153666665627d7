// Draws a frame that is prepared into a picture, row of tiles by row of tiles.
#pragma once

#include <string>
#include <vector>

#include "base/pool.h"
#include "rays/frame.h"
#include "rays/kernels.h"
#include "render/renderer.h"

namespace mimo::rays {

// The instruction sets that this build and this machine share, best first, e.g. "AVX2".
std::vector<std::string> simd_paths();

class Painter {
 public:
  // simd: one of simd_paths(); empty: the best. Throws Status::kUnsupported for another one.
  explicit Painter(const std::string& simd = {});

  // With several samples colours are averaged; depth and segmentation are those of the middle of the pixel. `pool` may
  // be null: the calling thread does it all. Throws Status::kInvalidArgument for a number of samples that it does not
  // know.
  void draw(const Frame& frame, const render::View& view, const render::Picture& picture, int samples,
            Pool* pool) const;

 private:
  void run(const Grid& grid, Pool* pool) const;

  DrawRow draw_;
};

}  // namespace mimo::rays
