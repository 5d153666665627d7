#include "recording/build.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <vector>

#include "recording/system.h"

namespace mimo::recording {
namespace {

// FNV-1a.
std::uint64_t hash_of_library() {
  std::uint64_t hash = 14695981039346656037u;
  std::ifstream file(path_of_this_library(), std::ios::binary);
  std::vector<char> piece(1 << 16);
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())), file.gcount() > 0) {
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      hash = (hash ^ static_cast<unsigned char>(piece[static_cast<std::size_t>(i)])) * 1099511628211u;
    }
  }
  return hash;
}

}  // namespace

std::string build_name(const std::string& versions) {
  static const std::uint64_t hash = hash_of_library();
  return fmt::format("{}, build {:016x}", versions, hash);
}

}  // namespace mimo::recording
