/* mimo_create's options. */
#ifndef MIMO_MATLAB_OPTIONS_H
#define MIMO_MATLAB_OPTIONS_H

#include "mimo_base.h"

/* create(scene, name, value, ...): the batch that the options ask for. */
mimo_batch* mimo_create_batch(int nin, const mxArray* in[]);

#endif
