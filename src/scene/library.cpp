#include "scene/library.h"

#include <fstream>
#include <iterator>

#include "scene/resources.h"

namespace mimo::scene {

Span<const unsigned char> built_in_file(const std::string& path) {
  for (std::size_t i = 0; i < kResourceCount; ++i) {
    if (path == kResources[i].path) return {kResources[i].data, kResources[i].size};
  }
  return {};
}

std::optional<std::string> read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) return std::nullopt;
  return content;
}

std::optional<std::string> Library::text(const std::string& path) const {
  if (!built_in()) return read_file(folder_ + "/" + path);
  const auto bytes = built_in_file(path);
  if (bytes.empty()) return std::nullopt;
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

bool Library::has(const std::string& path) const {
  return built_in() ? !built_in_file(path).empty() : static_cast<bool>(std::ifstream(folder_ + "/" + path));
}

}  // namespace mimo::scene
