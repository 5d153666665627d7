#include "render/format.h"

#include "render/pixels.h"

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

}  // namespace mimo::render
