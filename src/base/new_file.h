// Files that are written beside their place, and get their names when they are whole.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace mimo {

// An unused name in the folder of a file: moving within a folder needs no room on the disk.
std::filesystem::path beside(const std::filesystem::path& file, const std::string& ending = "");

// Moves a file to a name that must be free. Where it is not, the error is file_exists, and both stay as they are.
std::error_code move_to_free(const std::filesystem::path& file, const std::filesystem::path& name) noexcept;

}  // namespace mimo
