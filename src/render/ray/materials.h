// What solids are made of, in the terms of the kernels.
#pragma once

#include <mujoco/mjmodel.h>

#include "render/ray/scene.h"

namespace mimo::render::ray {

Power power(double exponent);

// Of a geom or site: its material (-1 for none) and its own colour.
Material material_of(const mjModel& model, int id, const float* rgba, Kind kind, const std::array<float, 3>& size,
                     bool is_plane_geom, const Textures& textures);

}  // namespace mimo::render::ray
