// Drawing over a picture: soft-edged strokes.
#pragma once

#include "cli/picture.h"

namespace cli {

// A place in a picture: pixels from its left and upper edge.
struct Spot {
  double x, y;
};

struct Ink {
  Rgb color;
  double opacity;  // 0 to 1
};

// A line of a given half width with round ends; a disc where both ends are the same.
void stroke(ColorPicture& picture, Spot from, Spot to, double radius, const Ink& ink);

// A stroke with a head at its end, wider by `rim` on all sides: drawn first with another ink it is an outline.
void arrow(ColorPicture& picture, Spot from, Spot to, double radius, const Ink& ink, double rim = 0);

}  // namespace cli
