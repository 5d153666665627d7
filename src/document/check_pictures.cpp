#include "document/check_pictures.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <iterator>
#include <new>
#include <string_view>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "document/attributes.h"
#include "document/files.h"
#include "document/report.h"
#include "engine/compiler.h"

namespace mimo::document {
namespace {

constexpr std::size_t kFirstChunk = 8, kAroundChunk = 12;
constexpr double kSlack = 65536;

// The compressed data, which may lie in many chunks.
std::vector<std::string_view> data_chunks(const LoadedFile& file) {
  const std::string& bytes = file.bytes();
  std::vector<std::string_view> chunks;
  for (std::size_t at = kFirstChunk; at + kAroundChunk <= bytes.size();) {
    const std::size_t length = big_endian(bytes, at);
    if (length > bytes.size() - at - kAroundChunk) file.refuse("ends within a chunk");
    if (bytes.compare(at + 4, 4, "IDAT") == 0) chunks.push_back(std::string_view(bytes).substr(at + 8, length));
    at += length + kAroundChunk;
  }
  return chunks;
}

// Bytes of the picture before compression: each row begins with the number of its filter.
double whole_bytes(const std::string& header) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(header[at]); };
  constexpr double kMostDepth = 16;
  const double channels = byte(25) == 2 ? 3 : byte(25) == 4 ? 2 : byte(25) == 6 ? 4 : 1;
  const double bits = channels * std::min<double>(byte(24), kMostDepth);
  return big_endian(header, 20) * (std::ceil(big_endian(header, 16) * bits / 8) + 1);
}

class Inflater {
 public:
  Inflater() {
    if (inflateInit(&stream_) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  // Whether more than `most` bytes came out so far. What is damaged ends here, and MuJoCo says so.
  bool exceeds(std::string_view more, double most) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(more.data()));
    stream_.avail_in = static_cast<uInt>(more.size());  // a chunk's length has 31 bits
    int result = Z_OK;
    while (result == Z_OK && out_ <= most) {
      stream_.next_out = room_.data();
      stream_.avail_out = static_cast<uInt>(room_.size());
      result = inflate(&stream_, Z_NO_FLUSH);
      out_ += static_cast<double>(room_.size() - stream_.avail_out);
    }
    return out_ > most;
  }

 private:
  z_stream stream_ = {};
  std::array<Bytef, 8192> room_;  // on stacks of 128 KiB, which hosts may have
  double out_ = 0;
};

using Size = PictureSize;

// More than this MuJoCo cannot count, whatever a caller allows.
constexpr double kMostPixels = 700e6;

double most_pixels(const Limits& limits) { return std::min(static_cast<double>(limits.pixels), kMostPixels); }

void require_pixels(pugi::xml_node node, Size size, const Limits& limits) {
  const double most = most_pixels(limits);
  if (size.width * size.height <= most) return;
  fail(Status::kModel, "{}: <{}> of {} x {} pixels, more than max_pixels ({})", where(node), node.name(), size.width,
       size.height, most);
}

struct Format {
  const char* name;
  std::size_t at;     // where
  const char* bytes;  // that tell it
};
constexpr Format kFormats[] = {{"PNG", 0, "\x89PNG\r\n\x1a\n"},
                               {"JPEG", 0, "\xff\xd8\xff"},
                               {"GIF", 0, "GIF8"},
                               {"WebP", 8, "WEBP"},
                               {"TIFF", 0, "II*"},
                               {"TIFF", 0, "MM"},
                               {"BMP", 0, "BM"},
                               {"AVIF or HEIF", 4, "ftyp"},
                               {"KTX", 0, "\xabKTX"},
                               {"DDS", 0, "DDS "},
                               {"PSD", 0, "8BPS"},
                               {"OpenEXR", 0, "v/1\x01"},
                               {"HDR", 0, "#?RADIANCE"},
                               {"PNM", 0, "P5\n"},
                               {"PNM", 0, "P6\n"}};

// The format of a picture by its first bytes; null where they tell none.
const char* format_of(const std::string& bytes) {
  const auto begins = [&](const Format& format) {
    return bytes.size() > format.at && bytes.compare(format.at, std::strlen(format.bytes), format.bytes) == 0;
  };
  const auto* const found = std::find_if(std::begin(kFormats), std::end(kFormats), begins);
  return found == std::end(kFormats) ? nullptr : found->name;
}

// What a PNG says at its beginning; its data is looked at where the size is allowed.
Size size_of_png(const LoadedFile& file, const Limits& limits) {
  constexpr std::size_t kHeader = 33;
  const std::string& bytes = file.bytes();
  const char* const format = format_of(bytes);
  if (format != nullptr && std::strcmp(format, "PNG") != 0) {
    file.refuse(mimo::format("is a {} picture, expected PNG", format));
  }
  if (format == nullptr || bytes.size() < kHeader || bytes.compare(12, 4, "IHDR") != 0) file.refuse("is no PNG");
  const Size size = png_size(file);
  if (size.width * size.height <= most_pixels(limits)) check_png_data(file);
  return size;
}

// Why a file that is no PNG by its name is none of numbers either: most of those are pictures in other formats.
[[noreturn]] void refuse_raw(const LoadedFile& file, const char* why) {
  const char* const format = format_of(file.bytes());
  if (format == nullptr) file.refuse(why);
  if (std::strcmp(format, "PNG") == 0) file.refuse("is a PNG picture, but its name does not end in .png");
  file.refuse(mimo::format("is a {} picture, expected PNG", format));
}

// Width, height and the pixels, of `each` bytes.
Size raw_size(const LoadedFile& file, std::size_t each) {
  const std::string& bytes = file.bytes();
  if (bytes.size() < 8) refuse_raw(file, "is too short for its header");
  const std::int32_t first = little_endian(bytes, 0), second = little_endian(bytes, 4);
  if (first < 1 || second < 1) refuse_raw(file, "has a size below 1 in its header");
  const double needed = 8 + double(first) * second * static_cast<double>(each);
  if (needed != static_cast<double>(bytes.size())) refuse_raw(file, "has another size than its header says");
  return {double(first), double(second)};
}

Size picture_size(pugi::xml_node node, const char* attribute, std::size_t each, const Limits& limits) {
  const LoadedFile file(node, attribute, limits);
  if (file.built_in()) return {};
  return file.extension() == ".png" ? size_of_png(file, limits) : raw_size(file, each);
}

void check_grid(pugi::xml_node texture) {
  constexpr double kMost = 12;
  for (const double size : numbers_in(texture, "gridsize")) {
    if (size >= 1 && size <= kMost) continue;
    fail(Status::kModel, "{}: gridsize=\"{}\", expected two numbers from 1 to {}", where(texture),
         texture.attribute("gridsize").value(), kMost);
  }
}

constexpr double kSides = 6;  // of a cube

// The cube that a file makes or is a side of. One file is all sides: a grid of them, or each is the whole picture.
Size cube_of(pugi::xml_node texture, bool one_side, Size picture) {
  const std::vector<double> grid = numbers_in(texture, "gridsize");  // rows, columns
  const double side = grid.size() == 2 && !one_side ? std::ceil(picture.width / grid[1]) : picture.width;
  return {side, kSides * side};
}

// Pixels that the model will have; `part` of them are counted here.
void take_pixels(pugi::xml_node texture, Size size, const Limits& limits, Budget& budget, double part = 1) {
  require_pixels(texture, size, limits);
  const double pixels = part * std::max(size.width, 0.0) * std::max(size.height, 0.0);
  budget.add_time(texture, cost::kPixel * pixels);
  budget.add_bytes(texture, (engine::is_mujoco_2() ? 3 : 4) * pixels);
}

bool is_flat(pugi::xml_node texture) { return std::strcmp(texture.attribute("type").value(), "2d") == 0; }

}  // namespace

PictureSize png_size(const LoadedFile& file) {
  return {double(big_endian(file.bytes(), 16)), double(big_endian(file.bytes(), 20))};
}

void check_png_data(const LoadedFile& file) {
  constexpr double kLongestCompressed = 1.01;  // of data that cannot be compressed
  constexpr double kInterlaced = 2;            // seven passes have less than twice as many rows
  const double whole = whole_bytes(file.bytes());
  const std::vector<std::string_view> chunks = data_chunks(file);
  double compressed = 0;
  for (const std::string_view chunk : chunks) compressed += static_cast<double>(chunk.size());
  const bool longer = compressed > kInterlaced * whole * kLongestCompressed + kSlack;
  Inflater inflater;
  const auto exceeds = [&](std::string_view chunk) { return inflater.exceeds(chunk, kInterlaced * whole + kSlack); };
  if (longer || std::any_of(chunks.begin(), chunks.end(), exceeds)) file.refuse("has more data than its size says");
}

void check_texture(pugi::xml_node texture, const Limits& limits, Budget& budget) {
  check_grid(texture);
  const std::string builtin = texture.attribute("builtin").value();
  if (!builtin.empty() && builtin != "none") {
    const double width = number(texture, "width").value_or(0), height = number(texture, "height").value_or(0);
    return take_pixels(texture, {width, is_flat(texture) ? height : kSides * width}, limits, budget);
  }
  constexpr std::size_t kBytes = 3;
  for (const char* file : {"file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"}) {
    if (!texture.attribute(file)) continue;
    const Size size = picture_size(texture, file, kBytes, limits);
    require_pixels(texture, size, limits);
    budget.add_time(texture, cost::kPixel * size.width * size.height);
    const bool one_side = std::strcmp(file, "file") != 0;
    const Size made = is_flat(texture) ? size : cube_of(texture, one_side, size);
    take_pixels(texture, made, limits, budget, one_side ? 1 / kSides : 1);
  }
}

void check_height_field(pugi::xml_node field, const Limits& limits, Budget& budget) {
  const bool has_file = !field.attribute("file").empty();
  const Size given{number(field, "ncol").value_or(0), number(field, "nrow").value_or(0)};
  require_pixels(field, given, limits);
  const Size size = has_file ? picture_size(field, "file", sizeof(float), limits) : given;
  require_pixels(field, size, limits);
  const double points = std::max(size.width, 0.0) * std::max(size.height, 0.0);
  budget.add_time(field, cost::kHeight * points);
  budget.add_bytes(field, sizeof(float) * points);
}

// OSMesa draws the shadows of a light into a picture of their own.
void check_shadows(pugi::xml_node quality, const Limits& limits) {
  const double size = number(quality, "shadowsize").value_or(0);
  require_pixels(quality, {size, size}, limits);
}

}  // namespace mimo::document
