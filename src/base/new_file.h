// Files that are written beside their place, and get their names when they are whole.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace mimo {

// A name that nobody has thought of, in the same folder as a file: to move there needs no room on the disk.
std::filesystem::path beside(const std::filesystem::path& file, const std::string& ending = "");

// Moves a file to a name that must be free. Where it is not, the error is file_exists, and both stay as they are.
std::error_code move_to_free(const std::filesystem::path& file, const std::filesystem::path& name) noexcept;

}  // namespace mimo
