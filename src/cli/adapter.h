// The library that a unit of FMI begins with, which the program holds (src/fmi).
#pragma once

#include <string_view>

namespace cli {

std::string_view unit_adapter();  // empty where units cannot be made

}  // namespace cli
