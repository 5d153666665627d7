// Files that a command reads and writes.
#pragma once

#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

bool has_ending(const std::string& path, const std::string& ending);  // ".png" is also that of a.PNG

// To be called before a command starts to work. Throws a Failure where the file could not be written because its folder
// is not there, or it is a folder itself, or a pipe that would be waited for.
void require_writable(const std::string& path);

// Writes a whole file, or throws a Failure and leaves what was there before. Devices and open pipes, as
// /dev/stdout, are written as they are.
void write_file(const std::string& path, std::string_view bytes);

// Makes a folder and all above it, where they are not there. Throws a Failure.
void make_folder(const std::string& path);

// Throws a Failure where the file cannot be read, and for what would be waited for or has no end.
std::ifstream open_to_read(const std::string& path);

// A whole file, or a Failure.
std::string read_file(const std::string& path);

// For CLI::Validator: complains of a name that ends in none of these, otherwise gives "".
std::function<std::string(const std::string&)> ends_in(const std::vector<std::string>& endings);

}  // namespace cli
