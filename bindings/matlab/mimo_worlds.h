/* Making, stepping, observing. */
#ifndef MIMO_MEX_WORLDS_H
#define MIMO_MEX_WORLDS_H

#include "mimo_base.h"

extern const mimo_command mimo_world_commands[];

#endif
