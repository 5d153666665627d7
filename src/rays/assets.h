// What renderers of one model share.
#pragma once

#include <vector>

#include "engine/model.h"
#include "rays/meshes.h"
#include "rays/skins.h"
#include "rays/textures.h"

namespace mimo::rays {

struct Assets {
  explicit Assets(const engine::ModelPtr& model) : textures(*model), meshes(*model), skins(skin_patterns(model)) {}

  const Textures textures;
  const Meshes meshes;
  const std::vector<SkinPattern> skins;
};

}  // namespace mimo::rays
