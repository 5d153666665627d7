#include "cli/picture.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "programs/files.h"
#include "programs/program.h"

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

double distance_to_line(Spot p, Spot from, Spot to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double square = dx * dx + dy * dy;
  const double share = square > 0 ? std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - from.x - share * dx, p.y - from.y - share * dy);
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, double share) {
  return static_cast<std::uint8_t>(std::lround(below + (above - below) * share));
}

// The pixels that a stroke between two coordinates may touch, along one axis.
struct Range {
  long begin, end;
};
Range touched(double a, double b, double margin, std::uint32_t size) {
  const double low = std::clamp(std::min(a, b) - margin, 0.0, static_cast<double>(size));
  const double high = std::clamp(std::max(a, b) + margin, 0.0, static_cast<double>(size));
  return {static_cast<long>(std::floor(low)), static_cast<long>(std::ceil(high))};
}

constexpr int kColumns = 5, kRows = 7, kAdvance = 6;

struct Letter {
  char name;
  std::uint8_t rows[kRows];  // a bit for each dot, the left one is the highest of five
};

constexpr Letter kLetters[] = {
    {'0', {0x0e, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0e}}, {'1', {0x04, 0x0c, 0x04, 0x04, 0x04, 0x04, 0x0e}},
    {'.', {0x00, 0x00, 0x00, 0x00, 0x00, 0x0c, 0x0c}}, {'A', {0x0e, 0x11, 0x11, 0x1f, 0x11, 0x11, 0x11}},
    {'B', {0x1e, 0x11, 0x11, 0x1e, 0x11, 0x11, 0x1e}}, {'C', {0x0e, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0e}},
    {'F', {0x1f, 0x10, 0x10, 0x1e, 0x10, 0x10, 0x10}}, {'K', {0x11, 0x12, 0x14, 0x18, 0x14, 0x12, 0x11}},
    {'N', {0x11, 0x19, 0x19, 0x15, 0x13, 0x13, 0x11}}, {'O', {0x0e, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0e}},
    {'R', {0x1e, 0x11, 0x11, 0x1e, 0x14, 0x12, 0x11}}, {'T', {0x1f, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04}},
};

constexpr double kWeak = 0.1, kStrong = 10;  // N
constexpr double kStops[][3] = {{255, 235, 130}, {250, 140, 40}, {215, 25, 30}, {110, 0, 60}};

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

void stroke(ColorPicture& picture, Spot from, Spot to, double radius, const Ink& ink) {
  const Range columns = touched(from.x, to.x, radius + 1, picture.width);
  const Range rows = touched(from.y, to.y, radius + 1, picture.height);
  for (long y = rows.begin; y < rows.end; ++y) {
    for (long x = columns.begin; x < columns.end; ++x) {
      const Spot middle{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
      const double cover = ink.opacity * std::clamp(radius + 0.5 - distance_to_line(middle, from, to), 0.0, 1.0);
      if (cover <= 0) continue;
      Rgb& pixel = picture.pixels[static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x)];
      pixel = {mixed(pixel.r, ink.color.r, cover), mixed(pixel.g, ink.color.g, cover),
               mixed(pixel.b, ink.color.b, cover)};
    }
  }
}

void arrow(ColorPicture& picture, Spot from, Spot to, double radius, const Ink& ink, double rim) {
  stroke(picture, from, to, radius + rim, ink);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length < 1) return;
  const double head = std::min(6 * radius, 0.5 * length);
  const double along = std::atan2(from.y - to.y, from.x - to.x);
  for (const double turn : {-0.45, 0.45}) {
    stroke(picture, to, {to.x + head * std::cos(along + turn), to.y + head * std::sin(along + turn)}, radius + rim,
           ink);
  }
}

double width_of(const std::string& text, double dot) {
  return dot * (kAdvance * static_cast<double>(text.size()) - (kAdvance - kColumns));
}

void write(ColorPicture& picture, const std::string& text, Spot left_middle, double dot, Rgb color) {
  double left = left_middle.x;
  const double top = left_middle.y - kRows * dot / 2;
  for (const char name : text) {
    const auto* letter =
        std::find_if(std::begin(kLetters), std::end(kLetters), [name](const Letter& one) { return one.name == name; });
    for (int i = 0; letter != std::end(kLetters) && i < kColumns * kRows; ++i) {
      const int column = i % kColumns, row = i / kColumns;
      const Spot middle{left + (column + 0.5) * dot, top + (row + 0.5) * dot};
      const bool dot_set = (letter->rows[row] >> (kColumns - 1 - column) & 1) != 0;
      if (dot_set) stroke(picture, middle, middle, dot / 2, {color, 1});
    }
    left += kAdvance * dot;
  }
}

double strength(double newtons) {
  return std::clamp(std::log(std::max(newtons, 1e-9) / kWeak) / std::log(kStrong / kWeak), 0.0, 1.0);
}

Rgb heat(double strength) {
  const double at = std::clamp(strength, 0.0, 1.0) * 3;
  const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(at), 2);
  const double rest = at - static_cast<double>(below);
  const auto part = [&](std::size_t i) {
    return static_cast<std::uint8_t>(std::lround(kStops[below][i] * (1 - rest) + kStops[below + 1][i] * rest));
  };
  return {part(0), part(1), part(2)};
}

void draw_scale(ColorPicture& picture) {
  const double unit = picture.height / 480.0, y = picture.height - 18 * unit;
  const double length = 160 * unit, left = picture.width / 2.0 - length / 2, letters = 2 * unit;
  stroke(picture, {left - 56 * unit, y}, {left + length + 48 * unit, y}, 14 * unit, {kPaper, 0.85});
  constexpr int kPieces = 80;
  for (int i = 0; i < kPieces; ++i) {
    const double x = left + length * (i + 0.5) / kPieces;
    stroke(picture, {x, y}, {x, y}, 4 * unit, {heat((i + 0.5) / kPieces), 1});
  }
  write(picture, "0.1 N", {left - 8 * unit - width_of("0.1 N", letters), y}, letters, kInk);
  write(picture, "10 N", {left + length + 8 * unit, y}, letters, kInk);
}

}  // namespace cli
