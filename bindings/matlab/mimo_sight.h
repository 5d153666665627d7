/* Commands for gaze, and for pictures for people. */
#ifndef MIMO_MATLAB_SIGHT_H
#define MIMO_MATLAB_SIGHT_H

#include "mimo_base.h"

extern const mimo_command mimo_sight_commands[];

#endif
