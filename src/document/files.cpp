#include "document/files.h"

#include <filesystem>

#include "base/fail.h"

namespace mimo::document {

void fail_large(const std::string& path, std::uint64_t bytes, std::uint64_t most_bytes) {
  fail(Status::kModel, "file {} has {} bytes, more than max_file_bytes ({})", path, bytes, most_bytes);
}

std::optional<std::string> read_file(const std::string& path, const Limits& limits) {
  if (limits.files == nullptr) return read_from_disk(path, limits.file_bytes);
  const auto found = limits.files->find(path);
  if (found == limits.files->end()) return std::nullopt;
  if (found->second.size() > limits.file_bytes) fail_large(path, found->second.size(), limits.file_bytes);
  return found->second;
}

bool lies_in(const std::string& path, const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path base = fs::weakly_canonical(folder.empty() ? fs::current_path(error) : fs::path(folder), error);
  if (error) return false;
  const fs::path file = fs::weakly_canonical(fs::path(path), error);
  if (error) return false;
  const fs::path relative = file.lexically_relative(base);
  return !relative.empty() && *relative.begin() != "..";
}

}  // namespace mimo::document
