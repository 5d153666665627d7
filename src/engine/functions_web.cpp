// What stands for the C library's functions in a module of WebAssembly, which brings its MuJoCo along: those that give
// the same bytes everywhere. The linker leads every call of a function to its __wrap_ (--wrap, cmake/MimoMujoco.cmake).
#include "base/functions.h"

namespace fixed = mimo::fixed;

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the names are the linker's
extern "C" {
double __wrap_exp(double x) { return fixed::exp(x); }
double __wrap_log(double x) { return fixed::log(x); }
double __wrap_pow(double x, double y) { return fixed::pow(x, y); }
double __wrap_sin(double x) { return fixed::sin(x); }
double __wrap_cos(double x) { return fixed::cos(x); }
double __wrap_tan(double x) { return fixed::tan(x); }
double __wrap_asin(double x) { return fixed::atan2(x, std::sqrt((1 - x) * (1 + x))); }
double __wrap_acos(double x) { return fixed::acos(x); }
double __wrap_atan2(double y, double x) { return fixed::atan2(y, x); }
}
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
