// The pixels of a picture: from what OpenGL gives to a Picture, and from there to what a caller wants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/renderer.h"

namespace mimo::render {

// How a caller wants the pixels of a picture to lie.

struct Format {
  bool alpha = false;      // colours have a fourth byte, 255
  bool bottom_up = false;  // row 0 is the bottom

  int colors() const { return alpha ? 4 : 3; }  // bytes a pixel
};

// From how renderers draw to a format, in place: `picture.rgb` has room for it.
void deliver(const Picture& picture, const Format& format);

// From what OpenGL gives (rows from the bottom, depth 0..1, ids as colours) to what a Picture holds, and from there to
// other layouts.

// The last row becomes the first.
void flip_rows(unsigned char* pixels, std::size_t row_bytes, int rows);

// Three bytes a pixel become four, in place: the fourth is 255.
void add_alpha(unsigned char* pixels, std::size_t count);

// Depth buffer values between these planes, of a perspective or of parallel rays -> metres along the camera's axis.
void depth_to_metres(float* depth, std::size_t count, double near, double far, bool parallel = false);

// Colours of MuJoCo's mjRND_IDCOLOR (red first, 0 is background, else 1 + index) -> the geoms of these indices.
void ids_to_geoms(const unsigned char* colours, std::size_t count, const std::vector<std::int32_t>& geoms,
                  std::int32_t* segmentation);

}  // namespace mimo::render
