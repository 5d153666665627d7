// fail(status, "size {} of {}", a, b): throws an Error with a formatted message.
#pragma once

// The small part of fmt; format.cpp has the rest. Most of a file's compile time hangs on this.
#include <fmt/core.h>

#include "base/status.h"

namespace mimo {

[[noreturn]] void fail_formatted(Status status, fmt::string_view format, fmt::format_args arguments);

template <typename... Args>
[[noreturn]] void fail(Status status, fmt::format_string<Args...> format, Args&&... args) {
  fail_formatted(status, format, fmt::make_format_args(args...));
}

// The commonest check: an argument that is not what was expected.
template <typename... Args>
void require(bool condition, fmt::format_string<Args...> format, Args&&... args) {
  if (!condition) fail_formatted(Status::kInvalidArgument, format, fmt::make_format_args(args...));
}

// A number that is out of its range, or no number. `unit` is told behind the range, as " seconds".
template <typename T>
void require_between(T value, T low, T high, const char* argument, const char* unit = "") {
  require(value >= low && value <= high, "{} is {}, expected {} to {}{}", argument, value, low, high, unit);
}

}  // namespace mimo
