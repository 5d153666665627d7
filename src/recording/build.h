// Which library recorded.
#pragma once

#include <string>

namespace mimo::recording {

// The versions, and a fingerprint of the file that the library was loaded from: two builds of one version are two.
std::string build_name(const std::string& versions);

// Of numbers in states, which are kept as they lie in memory: "little" or "big".
const char* byte_order();

}  // namespace mimo::recording
