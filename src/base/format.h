// Texts: begins_with(text, "robot:"), format("size {} of {}", a, b), join(list, ", "), some_of(names); safe lines and
// JSON; numbers read from text.
#pragma once

// The small part of fmt. The rest is compiled once, in format.cpp, and not into every file that includes this; most of
// a file's compile time hangs on it.
#include <fmt/core.h>

#include <charconv>
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

// Texts from outside (names, paths, what a task says, MuJoCo's messages, which it cuts anywhere) may hold anything.

// The text as it stands in messages, which are one line of UTF-8 that terminals only show: '?' for every byte that
// belongs to no letter, and escapes as in C for control characters and whatever else ends a line ("\n", "\x1b").
std::string as_line(const std::string& text);

// The text as a string of JSON, with its quotes.
std::string as_json(const std::string& text);

// What std::from_chars does for a double; the C++ library of some systems has it for whole numbers only.

std::from_chars_result read_double(const char* at, const char* end, double& value);

}  // namespace mimo
