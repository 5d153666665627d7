// Writes a unit of FMI.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fmi/variables.h"

namespace cli {

// `words` are the options that describe its world, without --scene; `adapter` is the library that the unit begins with.
// Throws a Failure, and leaves then what was there.
void write_unit(const std::string& path, const UnitOptions& options, std::vector<std::string> words,
                std::string_view adapter);

}  // namespace cli
