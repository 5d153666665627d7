// Compiled in many versions of C++ by CMakeLists.txt beside it.
// Twice on purpose, which clang-format would undo.
// clang-format off
#include "mimo/mimo.hpp"
#include "mimo/mimo.hpp"
// clang-format on

const char* header_alone();
const char* header_alone() { return mimo_version(); }
