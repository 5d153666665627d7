#include "document/library.h"

#include <filesystem>

#include "document/files.h"
#include "document/resources.h"

namespace mimo::document {

Span<const unsigned char> built_in_file(const std::string& path) {
  for (std::size_t i = 0; i < kResourceCount; ++i) {
    if (path == kResources[i].path) return {kResources[i].data, kResources[i].size};
  }
  return {};
}

std::optional<std::string> Library::text(const std::string& path) const {
  if (!built_in()) return read_file(folder_ + "/" + path, Limits{});
  const auto bytes = built_in_file(path);
  if (bytes.empty()) return std::nullopt;
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

bool Library::has(const std::string& path) const {
  std::error_code unknown;
  return built_in() ? !built_in_file(path).empty() : std::filesystem::exists(folder_ + "/" + path, unknown);
}

}  // namespace mimo::document
