// All of fmt, compiled in here: libmimo.so needs no libfmt.
#define FMT_HEADER_ONLY
#include "base/format.h"

#include <fmt/format.h>

namespace mimo {

std::string format_arguments(fmt::string_view format, fmt::format_args arguments) {
  return fmt::vformat(format, arguments);
}

std::string some_of(std::vector<std::string> names) {
  constexpr std::size_t kShown = 60;
  if (names.empty()) return "none";
  if (names.size() > kShown) {
    names.resize(kShown);
    names.emplace_back("...");
  }
  return join(names, ", ");
}

}  // namespace mimo
