#include "document/files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/fail.h"
#include "base/format.h"
#include "document/library.h"
#include "document/report.h"

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

LoadedFile::LoadedFile(pugi::xml_node asset, const char* attribute, const Limits& limits)
    : asset_(asset), path_(asset.attribute(attribute).value()) {
  const std::string prefix = "mimo/";
  built_in_ = begins_with(path_, prefix) && !built_in_file(path_.substr(prefix.size())).empty();
  if (built_in_) return;
  constexpr std::size_t kShortest = 4;  // MuJoCo looks for an ending of that length
  if (path_.size() < kShortest) refuse("has a name without an extension");
  std::optional<std::string> content = read(path_, limits);
  if (!content) refuse("cannot be read");
  bytes_ = std::move(*content);
}

std::optional<std::string> LoadedFile::read(const std::string& path, const Limits& limits) const {
  try {
    return read_file(path, limits);
  } catch (const Error& error) {
    fail(error.status(), "{}: {}", where(asset_), error.message());
  }
}

std::string extension_of(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] == '/') return "";
  std::string ending = path.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

void LoadedFile::refuse(const std::string& why) const {
  const std::string name = asset_.attribute("name").value();
  fail(Status::kModel, "{}: file {} of <{}{}> {}", where(asset_), path_, asset_.name(), name.empty() ? "" : " " + name,
       why);
}

}  // namespace mimo::document
