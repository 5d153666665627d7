// The few letters that pictures need.
#pragma once

#include <string>

#include "cli/canvas.h"

namespace cli {

// Capitals of 5 x 7 dots, each `dot` pixels wide. Knows the letters of what pictures say; leaves out all others.
double width_of(const std::string& text, double dot);
void write(ColorPicture& picture, const std::string& text, Spot left_middle, double dot, Rgb color);

}  // namespace cli
