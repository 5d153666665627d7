/* Compiled in many languages by CMakeLists.txt beside it: the header needs nothing before it and can come twice. */
/* Twice on purpose, which clang-format would undo. */
/* clang-format off */
#include "mimo/experimental.h"
#include "mimo/experimental.h"
/* clang-format on */

mimo_status header_alone(void);
mimo_status header_alone(void) { return MIMO_OK; }
