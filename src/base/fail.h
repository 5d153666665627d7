// fail(status, "size {} of {}", a, b): throws an Error with a formatted message.
#pragma once

#include <fmt/format.h>

#include "base/status.h"

namespace mimo {

template <typename... Args>
[[noreturn]] void fail(Status status, fmt::format_string<Args...> format, Args&&... args) {
  throw Error(status, fmt::format(format, std::forward<Args>(args)...));
}

// The commonest check: an argument that is not what was expected.
template <typename... Args>
void require(bool condition, fmt::format_string<Args...> format, Args&&... args) {
  if (!condition) fail(Status::kInvalidArgument, format, std::forward<Args>(args)...);
}

}  // namespace mimo
