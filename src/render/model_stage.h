// A model of MuJoCo as the plain arrays that renderers draw: pointers into it, made anew for every picture.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include "render/stage.h"

namespace mimo::render {

Stage stage_of(const mjModel& model);
Poses poses_of(const mjData& data);

Materials materials_of(const mjModel& model);
Meshes meshes_of(const mjModel& model);
Fields fields_of(const mjModel& model);

}  // namespace mimo::render
