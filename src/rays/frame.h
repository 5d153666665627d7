// One picture's scene as the kernels see it: every geom, light and eye in the form in which casting a ray is cheapest.
// It is the sum of what its makers give.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/model.h"
#include "rays/backdrop.h"
#include "rays/camera.h"
#include "rays/extras.h"
#include "rays/lights.h"
#include "rays/materials.h"
#include "rays/meshes.h"
#include "rays/solids.h"

namespace mimo::rays {

// What renderers of one model share.

struct Assets {
  Assets(const engine::ModelPtr& model, std::shared_ptr<const Textures> pictures)
      : textures_in_common(std::move(pictures)), meshes(*model), skins(skin_patterns(model)) {}

  const std::shared_ptr<const Textures> textures_in_common;
  const Textures& textures = *textures_in_common;
  const Meshes meshes;
  const std::vector<SkinPattern> skins;
};

// One picture's scene as the kernels see it: every geom, light and eye brought into the form in which casting a ray is
// cheapest. It is the sum of what its makers give.

struct Frame {
  Solids solids;
  Camera camera;
  Lights lights;
  Mirror mirror;
  Backdrop backdrop;
  const std::uint32_t* texels;

  // The assets outlive this.
  Frame(const mjModel& model, const Assets& assets);

  // Throws Status::kRender.
  void prepare(const mjModel& model, const mjData& data, const render::View& view, double aspect_ratio,
               const render::Quality& quality);

 private:
  const Textures& textures_;
};

}  // namespace mimo::rays
