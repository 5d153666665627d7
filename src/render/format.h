// How a caller wants the pixels of a picture to lie.
#pragma once

#include "render/renderer.h"

namespace mimo::render {

struct Format {
  bool alpha = false;      // colours have a fourth byte, 255
  bool bottom_up = false;  // row 0 is the bottom

  int colors() const { return alpha ? 4 : 3; }  // bytes a pixel
};

// From how renderers draw to a format, in place: `picture.rgb` has room for it.
void deliver(const Picture& picture, const Format& format);

}  // namespace mimo::render
