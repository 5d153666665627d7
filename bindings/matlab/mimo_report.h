/* Commands that describe worlds and the library. */
#ifndef MIMO_MATLAB_REPORT_H
#define MIMO_MATLAB_REPORT_H

#include "mimo_base.h"

extern const mimo_command mimo_report_commands[];

#endif
