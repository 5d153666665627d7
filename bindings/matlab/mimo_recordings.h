/* Commands for recordings and their replay. */
#ifndef MIMO_MATLAB_RECORDINGS_H
#define MIMO_MATLAB_RECORDINGS_H

#include "mimo_base.h"

extern const mimo_command mimo_recording_commands[];

#endif
