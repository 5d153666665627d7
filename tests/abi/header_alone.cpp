// Compiled in many versions of C++ by CMakeLists.txt beside it.
// clang-format off: it would take the second line for a mistake
#include "mimo/mimo.hpp"
#include "mimo/mimo.hpp"
// clang-format on

const char* header_alone();
const char* header_alone() { return mimo_version(); }
