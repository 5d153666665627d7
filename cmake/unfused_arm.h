// Comes before everything in C++ for 64-bit ARM. Eigen's vectors fuse multiplications where the compiler says that the
// processor can, although MimoOptions.cmake tells the compiler not to. Unfused, they add in the order of those of x86-64.
#include <arm_neon.h>
#undef __ARM_FEATURE_FMA
