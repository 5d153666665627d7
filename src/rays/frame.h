// One picture's scene as the kernels see it: every solid, light and eye in the form in which casting a ray is cheapest.
// It is the sum of what its makers give.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "base/span.h"
#include "rays/backdrop.h"
#include "rays/camera.h"
#include "rays/lights.h"
#include "rays/materials.h"
#include "rays/meshes.h"
#include "rays/solids.h"
#include "render/stage.h"

namespace mimo::rays {

// What renderers of one stage share: its textures, meshes and height fields, and surfaces at rest.

struct MovingSurface;

// Each may be in common with other assets.
struct Assets {
  Assets(std::shared_ptr<const Textures> pictures, std::shared_ptr<const Meshes> triangles,
         std::shared_ptr<const Meshes> height_fields, std::shared_ptr<const std::vector<MovingSurface>> moving)
      : all_textures(std::move(pictures)),
        all_meshes(std::move(triangles)),
        all_fields(std::move(height_fields)),
        all_surfaces(std::move(moving)) {}

  const Mesh* find(int shape_type, int data_id) const {
    return (shape_type == render::kFieldShape ? *all_fields : *all_meshes).find(shape_type, data_id);
  }

  const std::shared_ptr<const Textures> all_textures;
  const std::shared_ptr<const Meshes> all_meshes, all_fields;
  const std::shared_ptr<const std::vector<MovingSurface>> all_surfaces;
  const Textures& textures = *all_textures;
  const std::vector<MovingSurface>& surfaces = *all_surfaces;
};

// One picture's scene as the kernels see it: every solid, light and eye brought into the form in which casting a ray is
// cheapest. It is the sum of what its makers give.

struct Frame {
  Solids solids;
  Camera camera;
  Lights lights;
  Mirror mirror;
  Backdrop backdrop;
  const std::uint32_t* texels;

  // For so many extras at most; the assets outlive this.
  Frame(const render::Stage& stage, std::size_t extras, const Assets& assets);

  void prepare(const render::Stage& stage, const render::Poses& poses, Span<const Extra> extras,
               const render::View& view, double aspect_ratio, const render::Quality& quality);

 private:
  Frame(std::size_t most, const render::Stage& stage, const Assets& assets);

  const Textures& textures_;
};

}  // namespace mimo::rays
