// Where the program that runs lies.
#pragma once

#include <filesystem>

namespace cli {

// Its folder, without links; empty where the system does not tell.
std::filesystem::path folder_of_this_program();

}  // namespace cli
