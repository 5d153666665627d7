#include "fmi/zip.h"

#include <zlib.h>

#include <limits>

#include "programs/program.h"

namespace cli {
namespace {

constexpr std::uint16_t kVersion = 20, kDeflated = 8, kUtf8 = 1 << 11;
constexpr std::uint16_t kTime = 0, kDate = (1 << 5) | 1;  // 1980-01-01: the same world is the same file
constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50;
constexpr std::uint32_t kPlainFile = 0100644U << 16;

// Numbers of an archive have their lowest byte first.
void put(std::string& to, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to += static_cast<char>(value >> (8 * i) & 0xff);
}

std::string deflated(std::string_view bytes) {
  z_stream stream = {};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw Failure("zlib cannot compress");
  }
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int result = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw Failure("zlib cannot compress");
  return packed;
}

}  // namespace

void Zip::add(const std::string& path, std::string_view bytes) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max() / 2)
    throw Failure(path + " is too large for a ZIP archive");
  const std::string packed = deflated(bytes);
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
  std::string facts;  // which stand in both places
  put(facts, kVersion, 2);
  put(facts, kUtf8, 2);
  put(facts, kDeflated, 2);
  put(facts, kTime, 2);
  put(facts, kDate, 2);
  put(facts, sum, 4);
  put(facts, packed.size(), 4);
  put(facts, bytes.size(), 4);
  put(facts, path.size(), 2);
  put(facts, 0, 2);  // nothing more
  const std::size_t place = files_.size();
  put(files_, kLocal, 4);
  files_ += facts + path + packed;
  put(directory_, kCentral, 4);
  put(directory_, 3 << 8 | kVersion, 2);  // made on Unix
  directory_ += facts;
  put(directory_, 0, 2);  // no comment
  put(directory_, 0, 2);  // on the first disk
  put(directory_, 0, 2);
  put(directory_, kPlainFile, 4);
  put(directory_, place, 4);
  directory_ += path;
  ++count_;
}

std::string Zip::finish() {
  std::string whole = files_ + directory_;
  put(whole, kEnd, 4);
  put(whole, 0, 4);
  put(whole, count_, 2);
  put(whole, count_, 2);
  put(whole, directory_.size(), 4);
  put(whole, files_.size(), 4);
  put(whole, 0, 2);
  return whole;
}

}  // namespace cli
