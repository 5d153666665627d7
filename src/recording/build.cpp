#include "recording/build.h"

#include <atomic>
#include <cstdint>
#include <fstream>
#include <vector>

#include "base/format.h"
#include "base/hash.h"
#include "recording/system.h"

namespace mimo::recording {
namespace {

std::uint64_t hash_of_library() {
  Hash hash;
  std::ifstream file(path_of_this_library(), std::ios::binary);
  std::vector<std::uint8_t> piece(1 << 16);
  while (file.read(reinterpret_cast<char*>(piece.data()), static_cast<std::streamsize>(piece.size())),
         file.gcount() > 0) {
    hash.add({piece.data(), static_cast<std::size_t>(file.gcount())});
  }
  return hash.value();
}

// Reading the library takes a while, so each process does it once; threads that do it at the same time agree.
std::atomic<std::uint64_t> known_hash{0};

}  // namespace

std::string build_name(const std::string& versions) {
  std::uint64_t hash = known_hash;
  if (hash == 0) known_hash = hash = hash_of_library();
  return format("{}, build {:016x}", versions, hash);
}

const char* byte_order() {
  const std::uint16_t one = 1;
  return *reinterpret_cast<const std::uint8_t*>(&one) == 1 ? "little" : "big";
}

}  // namespace mimo::recording
