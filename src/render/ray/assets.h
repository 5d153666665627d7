// What renderers of one model share.
#pragma once

#include "render/ray/meshes.h"
#include "render/ray/textures.h"

namespace mimo::render::ray {

struct Assets {
  explicit Assets(const mjModel& model) : textures(model), meshes(model) {}

  const Textures textures;
  const Meshes meshes;
};

}  // namespace mimo::render::ray
