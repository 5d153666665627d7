// Texts from outside (names, paths, MuJoCo's messages, which it cuts anywhere) may hold bytes that are no UTF-8.
#pragma once

#include <string>

namespace mimo {

// The same text with a '?' for every byte that belongs to no letter of UTF-8: callers decode messages strictly.
std::string valid_utf8(std::string text);

}  // namespace mimo
