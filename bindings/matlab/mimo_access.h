/* Names, states, faces, locks, gravity. */
#ifndef MIMO_MATLAB_ACCESS_H
#define MIMO_MATLAB_ACCESS_H

#include "mimo_base.h"

extern const mimo_command mimo_access_commands[];

#endif
