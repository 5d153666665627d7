// From what OpenGL gives (rows from the bottom, depth 0..1, ids as colours) to what a Picture holds, and from there to
// other layouts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mimo::render {

// The last row becomes the first.
void flip_rows(unsigned char* pixels, std::size_t row_bytes, int rows);

// Three bytes a pixel become four, in place: the fourth is 255.
void add_alpha(unsigned char* pixels, std::size_t count);

// Depth buffer values of a perspective with these planes -> metres along the camera's axis.
void depth_to_metres(float* depth, std::size_t count, double near, double far);

// Colours of MuJoCo's mjRND_IDCOLOR (red first, 0 is background, else 1 + index) -> the geoms of these indices.
void ids_to_geoms(const unsigned char* colours, std::size_t count, const std::vector<std::int32_t>& geoms,
                  std::int32_t* segmentation);

}  // namespace mimo::render
