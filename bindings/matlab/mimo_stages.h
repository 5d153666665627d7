/* Commands for stages. */
#ifndef MIMO_MATLAB_STAGES_H
#define MIMO_MATLAB_STAGES_H

#include "mimo_base.h"

extern const mimo_command mimo_stage_commands[];

#endif
