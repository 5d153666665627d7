#include "document/loaded_file.h"

#include <algorithm>
#include <cctype>

#include "base/fail.h"
#include "base/format.h"
#include "base/status.h"
#include "document/files.h"
#include "document/library.h"
#include "document/lines.h"

namespace mimo::document {

LoadedFile::LoadedFile(pugi::xml_node asset, const char* attribute, const Limits& limits)
    : asset_(asset), path_(asset.attribute(attribute).value()) {
  const std::string prefix = "mimo/";
  built_in_ = begins_with(path_, prefix) && !built_in_file(path_.substr(prefix.size())).empty();
  if (built_in_) return;
  constexpr std::size_t kShortest = 4;  // MuJoCo looks for an ending of that length
  if (path_.size() < kShortest) refuse("has a name without an ending");
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
