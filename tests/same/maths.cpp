// The functions of the C library that MuJoCo calls in physics, by base/functions.h. Loaded before it (LD_PRELOAD), they
// make a world's bytes the same on all processors, which shows that nothing else makes them differ.
#include "base/substitutes.h"

namespace fixed = mimo::fixed;

#define MIMO_REPLACE(name) \
  extern "C" __attribute__((visibility("default"))) double name(double x) noexcept { return fixed::name(x); }
#define MIMO_REPLACE_2(name)                                                                   \
  extern "C" __attribute__((visibility("default"))) double name(double x, double y) noexcept { \
    return fixed::name(x, y);                                                                  \
  }

MIMO_SUBSTITUTES_OF_1(MIMO_REPLACE)
MIMO_SUBSTITUTES_OF_2(MIMO_REPLACE_2)

extern "C" __attribute__((visibility("default"))) void sincos(double x, double* sine, double* cosine) noexcept {
  *sine = fixed::sin(x);
  *cosine = fixed::cos(x);
}
