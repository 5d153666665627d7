#include "document/png.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <string_view>
#include <vector>

#include "document/binary.h"

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

}  // namespace mimo::document
