// Pictures: turning numbers into colours, writing files.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>

namespace cli {

using mimo::Picture;
using mimo::Rgb;
using ColorPicture = Picture<Rgb>;

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

}  // namespace cli
