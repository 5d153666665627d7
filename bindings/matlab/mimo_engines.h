/* Commands for engines. */
#ifndef MIMO_MATLAB_ENGINES_H
#define MIMO_MATLAB_ENGINES_H

#include "mimo_base.h"

extern const mimo_command mimo_engine_commands[];

#endif
