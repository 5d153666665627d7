#include "cli/adapter.h"

namespace cli {

std::string_view unit_adapter() { return {}; }

}  // namespace cli
