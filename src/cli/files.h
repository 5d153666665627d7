// Files that a command is going to write: looked at before it starts to work.
#pragma once

#include <string>

namespace cli {

bool has_ending(const std::string& path, const std::string& ending);  // ".png" is also that of a.PNG

// Throws a Failure where the file could not be written because its folder is not there, or it is a folder itself.
void require_writable(const std::string& path);

// For CLI::Validator: a complaint, or "".
std::string check_png(const std::string& path);
std::string check_wav(const std::string& path);
std::string check_png_or_npy(const std::string& path);

}  // namespace cli
