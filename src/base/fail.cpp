#include "base/fail.h"

#include "base/format.h"
#include "base/utf8.h"

namespace mimo {

void fail_formatted(Status status, fmt::string_view format, fmt::format_args arguments) {
  throw Error(status, as_line(format_arguments(format, arguments)));
}

}  // namespace mimo
