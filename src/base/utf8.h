// Texts from outside (names, paths, what a task says, MuJoCo's messages, which it cuts anywhere) may hold anything.
#pragma once

#include <string>

namespace mimo {

// The text as it stands in messages, which are one line of UTF-8 that terminals only show: '?' for every byte that
// belongs to no letter, and escapes as in C for control characters and whatever else ends a line ("\n", "\x1b").
std::string as_line(const std::string& text);

// The text as a string of JSON, with its quotes.
std::string as_json(const std::string& text);

}  // namespace mimo
