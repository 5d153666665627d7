// Pictures: numbers as colours, strokes and letters, and files.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>

namespace cli {

// Pictures: turning numbers into colours, writing files.

using mimo::Picture;
using mimo::Rgb;
using ColorPicture = Picture<Rgb>;

constexpr Rgb kPaper{255, 255, 255}, kInk{60, 60, 60};

// What an observation's field of pixels shows.
ColorPicture picture_in(const mimo_field& field, const mimo::Block& block);

// Red from the left eye, green and blue from the right: for red-cyan glasses.
ColorPicture anaglyph(const ColorPicture& left, const ColorPicture& right);

// A colour for each id that is easy to tell from its neighbours'; black for -1.
ColorPicture color_coded(const Picture<std::int32_t>& ids);

// Metres as 16-bit millimetres; 0 where there is nothing (an id of -1), or nothing nearer than 65.5 m.
Picture<std::uint16_t> millimetres(const Picture<float>& metres, const Picture<std::int32_t>& ids);

// A texture as a PNG file.
std::string png_of(const mimo::Texture& texture);

// Write a file or throw a Failure. .npy is NumPy's format.
void write_png(const std::string& path, const ColorPicture& picture);
void write_png(const std::string& path, const Picture<std::uint16_t>& picture);
void write_npy(const std::string& path, const Picture<float>& picture);
void write_npy(const std::string& path, const Picture<std::int32_t>& picture);

// A free camera that sees the infants and what is around them but walls and furniture, usually from the right and in
// front of them; no wall stands in its way if there is such a place. Draws small pictures to know.
mimo_picture_config overview(mimo::Env& env, std::uint32_t width = 640, std::uint32_t height = 480);

// Drawing over a picture: soft-edged strokes.

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

// The few letters that pictures need.

// Capitals of 5 x 7 dots, each `dot` pixels wide. Knows the letters of what pictures say; leaves out all others.
double width_of(const std::string& text, double dot);
void write(ColorPicture& picture, const std::string& text, Spot left_middle, double dot, Rgb color);

// Forces as colours, the same in all pictures: from 0.1 N (pale) by the logarithm to 10 N (dark).

double strength(double newtons);  // 0 for the weakest, 1 for the strongest that are told apart
Rgb heat(double strength);

// The scale, at the lower edge of a picture.
void draw_scale(ColorPicture& picture);

}  // namespace cli
