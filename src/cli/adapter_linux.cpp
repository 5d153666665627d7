#include "cli/adapter.h"

// Written by the assembler, src/cli/CMakeLists.txt.
extern "C" const char mimo_unit_first[];
extern "C" const char mimo_unit_last[];

namespace cli {

std::string_view unit_adapter() {
  return {mimo_unit_first, static_cast<std::size_t>(mimo_unit_last - mimo_unit_first)};
}

}  // namespace cli
