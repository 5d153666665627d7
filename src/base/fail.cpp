#include "base/format.h"  // before fail.h: it decides how fmt is compiled

#include "base/fail.h"

namespace mimo {

void fail_formatted(Status status, fmt::string_view format, fmt::format_args arguments) {
  throw Error(status, fmt::vformat(format, arguments));
}

}  // namespace mimo
