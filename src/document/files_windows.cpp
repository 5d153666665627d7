#include <cstdint>
#include <filesystem>
#include <fstream>

#include "base/fail.h"
#include "document/files.h"

namespace mimo::document {
namespace {

namespace fs = std::filesystem;

bool plain(const std::string& path) {
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  if (type == fs::file_type::directory) fail(Status::kModel, "file {} is a folder", path);
  return type == fs::file_type::regular;
}

}  // namespace

// Paths are UTF-8, which std::filesystem takes them for.
std::optional<std::string> read_from_disk(const std::string& path, std::uint64_t most_bytes) {
  if (!plain(path)) return std::nullopt;
  std::error_code error;
  const std::uint64_t size = fs::file_size(path, error);
  if (error) return std::nullopt;
  if (size > most_bytes) fail_large(path, size, most_bytes);
  std::ifstream file(fs::path(path), std::ios::binary);
  std::string content(size, '\0');
  file.read(content.data(), static_cast<std::streamsize>(size));
  if (file.bad() || !file.is_open()) return std::nullopt;
  content.resize(static_cast<std::size_t>(file.gcount()));  // shorter by now
  return content;
}

}  // namespace mimo::document
