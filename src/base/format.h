// begins_with(text, "robot:"), format("size {} of {}", a, b), join(list, ", ") and some_of(names): texts.
#pragma once

// The small part of fmt. The rest is compiled once, in format.cpp, and not into every file that includes this; most of
// a file's compile time hangs on it.
#include <fmt/core.h>

#include <string>
#include <string_view>
#include <vector>

namespace mimo {

inline bool begins_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

std::string format_arguments(fmt::string_view format, fmt::format_args arguments);

template <typename... Args>
std::string format(fmt::format_string<Args...> format, const Args&... args) {
  return format_arguments(format, fmt::make_format_args(args...));
}

template <typename List>
std::string join(const List& list, const char* separator) {
  std::string joined;
  const char* between = "";
  for (const auto& item : list) {
    joined += between;
    joined += format("{}", item);
    between = separator;
  }
  return joined;
}

// What a message lists: "none", or the names, as many as one can read.
std::string some_of(std::vector<std::string> names);

}  // namespace mimo
