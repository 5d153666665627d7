// The compiler reads this before each C++ file for 64-bit ARM. MimoOptions.cmake forbids it to fuse multiplications,
// but Eigen's vectors fuse them where the processor can. Without fusing, Eigen adds in the same order as on x86-64.
#include <arm_neon.h>
#undef __ARM_FEATURE_FMA
