#include "base/new_file.h"

#include <random>

#include "base/format.h"

namespace fs = std::filesystem;

namespace mimo {

fs::path beside(const fs::path& file, const std::string& ending) {
  std::random_device random;
  return file.parent_path() / format(".mimo-{:08x}{:08x}{}", random(), random(), ending);
}

// A second name is never given over a first one, but renaming may be: it is for file systems without second names.
std::error_code move_to_free(const fs::path& file, const fs::path& name) noexcept {
  std::error_code error, ignored;
  fs::create_hard_link(file, name, error);
  if (!error) {
    fs::remove(file, ignored);
    return error;
  }
  if (error == std::errc::file_exists || fs::exists(fs::symlink_status(name, ignored))) {
    return std::make_error_code(std::errc::file_exists);
  }
  fs::rename(file, name, error);
  return error;
}

}  // namespace mimo
