#include "files.h"

#include <algorithm>
#include <filesystem>

#include "failure.h"

namespace cli {

bool has_ending(const std::string& path, const std::string& ending) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return path.size() > ending.size() &&
         std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [&](char wanted, char there) { return same(there, wanted); });
}

void require_writable(const std::string& path) {
  const std::filesystem::path file(path), folder = file.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw Failure("cannot write " + path + ": there is no folder " + folder.string());
  }
  if (std::filesystem::is_directory(file)) throw Failure("cannot write " + path + ": it is a folder");
}

std::string check_png(const std::string& path) {
  return has_ending(path, ".png") ? "" : "expected a name that ends in .png, not '" + path + "'";
}

std::string check_wav(const std::string& path) {
  return has_ending(path, ".wav") ? "" : "expected a name that ends in .wav, not '" + path + "'";
}

std::string check_png_or_npy(const std::string& path) {
  const bool good = has_ending(path, ".png") || has_ending(path, ".npy");
  return good ? "" : "expected a name that ends in .png or .npy, not '" + path + "'";
}

}  // namespace cli
