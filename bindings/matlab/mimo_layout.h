/* Commands for descriptions of observations, actions and rewards, and for observations. */
#ifndef MIMO_MATLAB_LAYOUT_H
#define MIMO_MATLAB_LAYOUT_H

#include "mimo_base.h"

extern const mimo_command mimo_layout_commands[];

/* A field that has the same name in MATLAB as another field, as "a/b" and "a_b" do; or NULL. */
const char* mimo_ambiguous_field(const worlds* all);

#endif
