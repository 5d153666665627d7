// What an eye sees of a solid.
#pragma once

#include "render/ray/scene.h"

namespace mimo::render::ray {

constexpr double kEverywhere = 1e9;  // beyond all bounds

// Adds a solid to what an eye sees, unless all of it is behind the eye or too far away.
void look_at(const Solid& solid, int index, Eye& eye, double near_depth);

}  // namespace mimo::render::ray
