// What something is painted with, and whether it is drawn at all, as MuJoCo has it.
#pragma once

#include <mujoco/mjmodel.h>

#include <array>

#include "render/texture_mapping.h"

namespace mimo::render {

struct Paint {
  std::array<float, 4> color{};
  float emission = 0;
  float specular = 0.5F;
  float shininess = 0.5F;
  float reflectance = 0;
  int texture = -1;
};

// Of a geom or site: its material (-1 for none) and its own colour.
Paint paint_of(const mjModel& model, int material, const float* rgba);

// The form of a mjtGeom; false for what has none of its own.
bool form_of(int type, Form& form);

// Of the groups that MuJoCo shows by default.
bool is_shown(int group);

}  // namespace mimo::render
