// Pictures blurred by a Gaussian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/span.h"
#include "observation/contrast.h"

namespace mimo::observation {

// The Gaussian that pictures are blurred with.

// Half of the kernel, from its middle outwards, for a Gaussian of `sigma` pixels; the whole kernel's sum is exactly 1.
// What it leaves of a grating of f cycles per pixel follows exp(-2 pi^2 sigma^2 f^2): up to f = 0.4 within 0.006; at f
// = 0.5 it leaves up to 0.08 more. Below 0.7 pixels no weights above 0 can do that: those 2 pixels away are down to
// -0.015 then, and the smoother sees to it that no edge gets a ring.
std::vector<float> gaussian_kernel(double sigma);

// Pictures blurred along rows and columns at once, row by row, so that only a few rows are on the way at a time.

class Smoother {
 public:
  // `planes` colours; the kernel from its middle outwards. Beyond its edges a picture goes on as it is there. Where the
  // kernel has weights below 0, nothing becomes darker or brighter than it and its two neighbours are: a grating does
  // not come to that, and an edge gets no ring.
  Smoother(std::size_t height, std::size_t width, std::size_t planes, const std::vector<float>& kernel);

  // Rows from the first to the last: `read` fills row y, its colours `apart()` from each other, `write` gets it
  // blurred, its colours one right after the other. Row y is written only after all rows that it needs were read, and
  // itself.
  void run(FunctionRef<void(std::size_t y, Light* row)> read, FunctionRef<void(std::size_t y, const Light* row)> write);

  std::size_t apart() const { return width_ + 2 * reach_; }

 private:
  Light* row(std::size_t y);
  void blur_row(std::size_t plane, Light* out);
  void blur_column(std::size_t y);
  void weigh(const Light* middle, std::size_t count, Light* out) const;

  std::size_t height_, width_, planes_, reach_;
  bool sharpens_ = false;  // there are weights below 0
  std::size_t slots_ = 0;  // rows kept but one: only ones in binary, since divisions take as long as half a row
  std::vector<std::int16_t> weights_;         // of both neighbours together, in 65536ths: from 1 pixel away on
  std::vector<Light> read_;                   // a row, with what it is taken for beyond its edges
  std::vector<Light> rows_;                   // the last rows, blurred along themselves
  std::vector<Light> written_;                // a row blurred both ways
  std::vector<const Light*> before_, after_;  // neighbours of the row that is weighed
};

}  // namespace mimo::observation
