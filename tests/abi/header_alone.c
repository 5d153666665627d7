/* Compiled in many languages by CMakeLists.txt beside it: the header needs nothing before it and can come twice. */
#include "mimo/mimo.h"
#include "mimo/mimo.h"

mimo_status header_alone(void);
mimo_status header_alone(void) { return MIMO_OK; }
