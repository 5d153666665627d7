/* Commands for scenes. */
#ifndef MIMO_MATLAB_SCENES_H
#define MIMO_MATLAB_SCENES_H

#include "mimo_base.h"

extern const mimo_command mimo_scene_commands[];

/* create(scene, name, value, ...): the batch that the options describe, and its config. Its messages
   has the number. */
mimo_batch* mimo_create_batch(int nin, const mxArray* in[], double number, mimo_batch_config* config,
                              mimo_growth* usual);

#endif
