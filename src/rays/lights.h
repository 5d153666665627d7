// The lights of a frame, and what they see: whatever something else sees first lies in shadow.
#pragma once

#include "render/ray/scene.h"

namespace mimo::render::ray {

// The headlight, then the scene's lights; all of them also in the frame of each solid.
void gather_lights(const mjModel& model, const mjData& data, bool shadows, Scene& scene);

// After the camera has looked around.
void cast_shadows(Scene& scene);

}  // namespace mimo::render::ray
