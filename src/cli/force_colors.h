// Forces as colours, the same in all pictures: from 0.1 N (pale) by the logarithm to 10 N (dark).
#pragma once

#include "cli/picture.h"

namespace cli {

double strength(double newtons);  // 0 for the weakest, 1 for the strongest that are told apart
Rgb heat(double strength);

// The scale, at the lower edge of a picture.
void draw_scale(ColorPicture& picture);

}  // namespace cli
