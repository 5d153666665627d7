// What renderers of one model share.
#pragma once

#include <vector>

#include "engine/model.h"
#include "render/ray/meshes.h"
#include "render/ray/skins.h"
#include "render/ray/textures.h"

namespace mimo::render::ray {

struct Assets {
  explicit Assets(const engine::ModelPtr& model) : textures(*model), meshes(*model), skins(skin_patterns(model)) {}

  const Textures textures;
  const Meshes meshes;
  const std::vector<SkinPattern> skins;
};

}  // namespace mimo::render::ray
