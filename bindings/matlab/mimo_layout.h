/* What worlds observe, act with and are rewarded for. */
#ifndef MIMO_MATLAB_LAYOUT_H
#define MIMO_MATLAB_LAYOUT_H

#include "mimo_base.h"

extern const mimo_command mimo_layout_commands[];

/* The field that has another one's name once both are written as MATLAB writes names: "a/b" and "a_b"; or NULL. */
const char* mimo_ambiguous_field(const worlds* all);

#endif
