#include "cli/picture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "programs/failure.h"
#include "programs/files.h"

namespace cli {
namespace {

// Hue, saturation and value, each 0 to 1.
Rgb from_hsv(double hue, double saturation, double value) {
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue * 6, 6);
    const double share = value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
    return static_cast<std::uint8_t>(std::lround(255 * share));
  };
  return {channel(5), channel(3), channel(1)};
}

// libpng writes into memory: what a file gets is whole.
std::string png_of(std::uint32_t format, std::uint32_t width, std::uint32_t height, const void* pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = format;
  png_alloc_size_t bytes = 0;
  if (png_image_write_to_memory(&image, nullptr, &bytes, 0, pixels, 0, nullptr) == 0) throw Failure(image.message);
  std::string png(bytes, '\0');
  if (png_image_write_to_memory(&image, png.data(), &bytes, 0, pixels, 0, nullptr) == 0) throw Failure(image.message);
  png.resize(bytes);
  return png;
}

template <typename Pixel>
void write_array(const std::string& path, const char* type, const Picture<Pixel>& picture) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the types below are named as little-endian");
  std::string header = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (" +
                       std::to_string(picture.height) + ", " + std::to_string(picture.width) + "), }";
  constexpr std::size_t kPreamble = 10;  // magic, version, length of the header
  header.append(63 - (kPreamble + header.size()) % 64, ' ');
  header += '\n';
  const char length[2] = {static_cast<char>(header.size() & 0xff), static_cast<char>(header.size() >> 8)};

  std::string file = std::string("\x93NUMPY\x01\x00", 8).append(length, 2) + header;
  file.append(reinterpret_cast<const char*>(picture.pixels.data()), picture.pixels.size() * sizeof(Pixel));
  write_file(path, file);
}

}  // namespace

ColorPicture picture_in(const mimo_field& field, const mimo::Block& block) {
  const auto bytes = block.view<std::uint8_t>(field);
  const Rgb* pixels = reinterpret_cast<const Rgb*>(bytes.data());
  return {static_cast<std::uint32_t>(field.shape[1]), static_cast<std::uint32_t>(field.shape[0]),
          std::vector<Rgb>(pixels, pixels + bytes.size() / sizeof(Rgb))};
}

ColorPicture anaglyph(const ColorPicture& left, const ColorPicture& right) {
  ColorPicture both = right;
  for (std::size_t i = 0; i < both.pixels.size(); ++i) both.pixels[i].r = left.pixels[i].r;
  return both;
}

ColorPicture color_coded(const Picture<std::int32_t>& ids) {
  ColorPicture colors{ids.width, ids.height, {}};
  for (const std::int32_t id : ids.pixels) {
    // Steps of the golden ratio around the colour wheel never come close to each other.
    const double hue = std::fmod(id * 0.618033988749895, 1.0);
    colors.pixels.push_back(id < 0 ? Rgb{0, 0, 0} : from_hsv(hue, 0.55 + 0.15 * (id % 3), 1.0 - 0.2 * (id % 2)));
  }
  return colors;
}

Picture<std::uint16_t> millimetres(const Picture<float>& metres, const Picture<std::int32_t>& ids) {
  Picture<std::uint16_t> picture{metres.width, metres.height, {}};
  for (std::size_t i = 0; i < metres.pixels.size(); ++i) {
    const double value = std::round(metres.pixels[i] * 1000.0);
    const bool fits = ids.pixels[i] >= 0 && value >= 0 && value <= std::numeric_limits<std::uint16_t>::max();
    picture.pixels.push_back(fits ? static_cast<std::uint16_t>(value) : 0);
  }
  return picture;
}

std::string png_of(const mimo::Texture& texture) {
  return png_of(PNG_FORMAT_RGBA, texture.width, texture.height, texture.pixels.data());
}

void write_png(const std::string& path, const ColorPicture& picture) {
  write_file(path, png_of(PNG_FORMAT_RGB, picture.width, picture.height, picture.pixels.data()));
}

void write_png(const std::string& path, const Picture<std::uint16_t>& picture) {
  write_file(path, png_of(PNG_FORMAT_LINEAR_Y, picture.width, picture.height, picture.pixels.data()));
}

void write_npy(const std::string& path, const Picture<float>& picture) { write_array(path, "<f4", picture); }

void write_npy(const std::string& path, const Picture<std::int32_t>& picture) { write_array(path, "<i4", picture); }

}  // namespace cli
