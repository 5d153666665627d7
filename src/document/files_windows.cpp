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
std::optional<std::string> read_file(const std::string& path, const Limits& limits) {
  if (!plain(path)) return std::nullopt;
  std::error_code error;
  const std::uint64_t size = fs::file_size(path, error);
  if (error) return std::nullopt;
  if (size > limits.file_bytes) {
    fail(Status::kModel, "file {} has {} bytes, more than max_file_bytes ({})", path, size, limits.file_bytes);
  }
  std::ifstream file(fs::path(path), std::ios::binary);
  std::string content(size, '\0');
  file.read(content.data(), static_cast<std::streamsize>(size));
  if (file.bad() || !file.is_open()) return std::nullopt;
  content.resize(static_cast<std::size_t>(file.gcount()));  // shorter by now
  return content;
}

}  // namespace mimo::document
