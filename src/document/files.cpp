#include "document/files.h"

#include <filesystem>

namespace mimo::document {

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
