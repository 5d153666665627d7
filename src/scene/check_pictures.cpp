#include "scene/check_pictures.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "base/fail.h"
#include "scene/attributes.h"
#include "scene/binary.h"
#include "scene/lines.h"
#include "scene/loaded_file.h"

namespace mimo::scene {
namespace {

struct Size {
  double width = 0, height = 0;
};

// More than this MuJoCo cannot count, whatever a caller allows.
constexpr double kMostPixels = 700e6;

void require_pixels(pugi::xml_node node, Size size, const Limits& limits) {
  const double most = std::min(static_cast<double>(limits.pixels), kMostPixels);
  if (size.width * size.height <= most) return;
  fail(Status::kModel, "{}: <{}> of {} x {} pixels, more than max_pixels ({})", where(node), node.name(), size.width,
       size.height, most);
}

// What a PNG says at its beginning. Compressed data that is longer than the picture in full makes a reader fill its
// memory for nothing; no writer makes such.
Size png_size(const LoadedFile& file) {
  constexpr std::size_t kHeader = 33, kFirstChunk = 8, kSlack = 65536;
  const std::string& bytes = file.bytes();
  if (bytes.size() < kHeader || std::memcmp(bytes.data(), "\x89PNG\r\n\x1a\n", 8) != 0 ||
      bytes.compare(12, 4, "IHDR") != 0) {
    file.refuse("is no PNG");
  }
  const Size size{double(big_endian(bytes, 16)), double(big_endian(bytes, 20))};
  const double full = size.width * size.height * 8;
  double compressed = 0;
  for (std::size_t at = kFirstChunk; at + 12 <= bytes.size();) {
    const std::size_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - 12) file.refuse("ends within a chunk");
    if (bytes.compare(at + 4, 4, "IDAT") == 0) compressed += static_cast<double>(length);
    at += length + 12;
  }
  if (compressed > full * 1.01 + kSlack) file.refuse("has more data than its size says");
  return size;
}

// Width, height and the pixels, of `each` bytes.
Size raw_size(const LoadedFile& file, std::size_t each) {
  const std::string& bytes = file.bytes();
  if (bytes.size() < 8) file.refuse("is too short for its header");
  const std::int32_t first = little_endian(bytes, 0), second = little_endian(bytes, 4);
  if (first < 1 || second < 1) file.refuse("has a size below 1 in its header");
  const double needed = 8 + double(first) * second * static_cast<double>(each);
  if (needed != static_cast<double>(bytes.size())) file.refuse("has another size than its header says");
  return {double(first), double(second)};
}

Size picture_size(pugi::xml_node node, const char* attribute, std::size_t each, const Limits& limits) {
  const LoadedFile file(node, attribute, limits);
  if (file.built_in()) return {};
  return file.extension() == ".png" ? png_size(file) : raw_size(file, each);
}

void check_grid(pugi::xml_node texture) {
  constexpr double kMost = 12;
  for (const double size : numbers_in(texture, "gridsize")) {
    if (size >= 1 && size <= kMost) continue;
    fail(Status::kModel, "{}: gridsize=\"{}\", expected two numbers from 1 to {}", where(texture),
         texture.attribute("gridsize").value(), kMost);
  }
}

bool is_flat(pugi::xml_node texture) { return std::strcmp(texture.attribute("type").value(), "2d") == 0; }

}  // namespace

void check_texture(pugi::xml_node texture, const Limits& limits) {
  check_grid(texture);
  const std::string builtin = texture.attribute("builtin").value();
  if (!builtin.empty() && builtin != "none") {
    const double width = number(texture, "width").value_or(0), height = number(texture, "height").value_or(0);
    return require_pixels(texture, {width, is_flat(texture) ? height : 6 * width}, limits);
  }
  constexpr std::size_t kBytes = 3;
  for (const char* file : {"file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"}) {
    if (!texture.attribute(file)) continue;
    const Size size = picture_size(texture, file, kBytes, limits);
    require_pixels(texture, size, limits);
    if (!is_flat(texture)) require_pixels(texture, {size.width, 6 * size.width}, limits);
  }
}

void check_height_field(pugi::xml_node field, const Limits& limits) {
  const Size given{number(field, "ncol").value_or(0), number(field, "nrow").value_or(0)};
  require_pixels(field, given, limits);
  if (field.attribute("file")) require_pixels(field, picture_size(field, "file", sizeof(float), limits), limits);
}

// OSMesa draws the shadows of a light into a picture of their own.
void check_shadows(pugi::xml_node quality, const Limits& limits) {
  const double size = number(quality, "shadowsize").value_or(0);
  require_pixels(quality, {size, size}, limits);
}

}  // namespace mimo::scene
