// What solids are made of, in the terms of the kernels.
#pragma once

#include <mujoco/mjmodel.h>

#include "render/ray/scene.h"

namespace mimo::render::ray {

Power power(double exponent);

// What a texture is laid on.
struct Shape {
  Kind kind;
  std::array<float, 3> size;  // as the model has it
  bool prescaled;             // drawn at its size, not as a unit shape that is scaled: planes and meshes of the model
  bool given;                 // has texture coordinates of its own
};

// Of a geom or site: its material (-1 for none) and its own colour.
Material material_of(const mjModel& model, int id, const float* rgba, const Shape& shape, const Textures& textures);

}  // namespace mimo::render::ray
