/* Scenes: what worlds are made of. */
#ifndef MIMO_MATLAB_SCENES_H
#define MIMO_MATLAB_SCENES_H

#include "mimo_base.h"

extern const mimo_command mimo_scene_commands[];

/* create(scene, name, value, ...): the batch that the options ask for. */
mimo_batch* mimo_create_batch(int nin, const mxArray* in[]);

#endif
