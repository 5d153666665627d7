#include "cli/adapter.h"

#ifdef MIMO_HOLDS_UNIT  // CMake puts the library's bytes between these

extern "C" const char mimo_unit_first[], mimo_unit_last[];

#endif

namespace cli {

std::string_view unit_adapter() {
#ifdef MIMO_HOLDS_UNIT
  return {mimo_unit_first, static_cast<std::size_t>(mimo_unit_last - mimo_unit_first)};
#else
  return {};
#endif
}

}  // namespace cli
