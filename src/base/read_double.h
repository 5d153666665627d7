// What std::from_chars does for a double; the C++ library of some systems has it for whole numbers only.
#pragma once

#include <charconv>

namespace mimo {

std::from_chars_result read_double(const char* at, const char* end, double& value);

}  // namespace mimo
