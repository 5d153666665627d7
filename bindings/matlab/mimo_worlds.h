/* Commands for making, stepping and observing worlds. */
#ifndef MIMO_MATLAB_WORLDS_H
#define MIMO_MATLAB_WORLDS_H

#include "mimo_base.h"

extern const mimo_command mimo_world_commands[];

#endif
