#include "base/fail.h"

#include <utility>

#include "base/format.h"
#include "common/nearest.h"

namespace mimo {
void fail_formatted(Status status, fmt::string_view format, fmt::format_args arguments) {
  throw Error(status, as_line(format_arguments(format, arguments)));
}

std::string choice_of(const std::string& wanted, std::vector<std::string> names) {
  const std::string meant = nearest(wanted, names);
  const std::string all = some_of(std::move(names));
  return meant.empty() ? format("there are: {}", all) : format("did you mean \"{}\"? there are: {}", meant, all);
}

}  // namespace mimo
