// Compiled in many versions of C++ by CMakeLists.txt beside it.
#include "mimo/mimo.hpp"
#include "mimo/mimo.hpp"

const char* header_alone();
const char* header_alone() { return mimo_version(); }
