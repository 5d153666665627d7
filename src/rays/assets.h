// What renderers of one model share.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/model.h"
#include "rays/meshes.h"
#include "rays/skins.h"
#include "rays/textures.h"

namespace mimo::rays {

struct Assets {
  Assets(const engine::ModelPtr& model, std::shared_ptr<const Textures> pictures)
      : textures_in_common(std::move(pictures)), meshes(*model), skins(skin_patterns(model)) {}

  const std::shared_ptr<const Textures> textures_in_common;
  const Textures& textures = *textures_in_common;
  const Meshes meshes;
  const std::vector<SkinPattern> skins;
};

}  // namespace mimo::rays
