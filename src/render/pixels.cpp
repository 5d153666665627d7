#include "render/pixels.h"

#include <algorithm>

namespace mimo::render {
namespace {

// Turns a picture with so many numbers a pixel upside down; null pointers stay what they are.
template <typename T>
void flip(T* pixels, int numbers, const Picture& picture) {
  if (pixels == nullptr) return;
  const std::size_t row = static_cast<std::size_t>(numbers) * static_cast<std::size_t>(picture.width) * sizeof(T);
  flip_rows(reinterpret_cast<unsigned char*>(pixels), row, picture.height);
}

}  // namespace

void deliver(const Picture& picture, const Format& format) {
  const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (format.alpha && picture.rgb != nullptr) add_alpha(picture.rgb, pixels);
  if (!format.bottom_up) return;
  flip(picture.rgb, format.colors(), picture);
  flip(picture.depth, 1, picture);
  flip(picture.segmentation, 1, picture);
}

void flip_rows(unsigned char* pixels, std::size_t row_bytes, int rows) {
  for (int top = 0, bottom = rows - 1; top < bottom; ++top, --bottom) {
    unsigned char* first = pixels + static_cast<std::size_t>(top) * row_bytes;
    std::swap_ranges(first, first + row_bytes, pixels + static_cast<std::size_t>(bottom) * row_bytes);
  }
}

void add_alpha(unsigned char* pixels, std::size_t count) {
  for (std::size_t i = count; i-- > 0;) {  // from the end: no pixel is overwritten before it was moved
    const unsigned char red = pixels[3 * i], green = pixels[3 * i + 1], blue = pixels[3 * i + 2];
    pixels[4 * i] = red;
    pixels[4 * i + 1] = green;
    pixels[4 * i + 2] = blue;
    pixels[4 * i + 3] = 255;
  }
}

void depth_to_metres(float* depth, std::size_t count, double near, double far, bool parallel) {
  if (parallel) {
    for (std::size_t i = 0; i < count; ++i) depth[i] = static_cast<float>(near + depth[i] * (far - near));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    depth[i] = static_cast<float>(near * far / (far - static_cast<double>(depth[i]) * (far - near)));
  }
}

void ids_to_geoms(const unsigned char* colours, std::size_t count, const std::vector<std::int32_t>& geoms,
                  std::int32_t* segmentation) {
  for (std::size_t i = 0; i < count; ++i, colours += 3) {
    const std::uint32_t id =
        colours[0] | static_cast<std::uint32_t>(colours[1]) << 8 | static_cast<std::uint32_t>(colours[2]) << 16;
    segmentation[i] = id == 0 || id > geoms.size() ? -1 : geoms[id - 1];
  }
}

}  // namespace mimo::render
