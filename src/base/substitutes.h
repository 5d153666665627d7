// The functions of the C library that MuJoCo calls in physics, each of which has a substitute in base/functions.h.
#pragma once

#include "base/functions.h"

// Calls a macro for each, by the number of arguments.
#define MIMO_SUBSTITUTES_OF_1(DO) DO(exp) DO(log) DO(sin) DO(cos) DO(tan) DO(asin) DO(acos)
#define MIMO_SUBSTITUTES_OF_2(DO) DO(pow) DO(atan2)

namespace mimo {

#define MIMO_NAME(name) name,
// Their numbers in pages of recordings (cli/page.cpp, engine/functions_web.cpp).
enum class Substitute : unsigned { MIMO_SUBSTITUTES_OF_1(MIMO_NAME) MIMO_SUBSTITUTES_OF_2(MIMO_NAME) };
#undef MIMO_NAME

namespace fixed {

double asin(double x);  // the library itself needs none

}  // namespace fixed
}  // namespace mimo
