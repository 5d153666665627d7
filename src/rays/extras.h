// What MuJoCo computes for every picture: the pieces of spatial tendons and slider-cranks, and skins.
#pragma once

#include <mujoco/mjmodel.h>
#include <mujoco/mjvisualize.h>

#include <array>
#include <vector>

#include "engine/model.h"
#include "rays/meshes.h"
#include "rays/vectors.h"
#include "render/visual_scene.h"

namespace mimo::rays {

// MuJoCo's skins: triangles that follow several bodies, so that they lie differently in every picture.

// A skin in the model's reference pose. Which triangles a box of its tree holds is settled there, once for a model:
// pictures do not depend on those before.
class SkinPattern {
 public:
  SkinPattern(const mjModel& model, int id, const float* vertices);

  const Mesh& mesh() const { return mesh_; }
  // Moves the corners of a copy of the mesh to where the skin's vertices are now. Returns the place around which it
  // lies.
  Vec drape(const float* vertices, const float* normals, Mesh& mesh) const;

 private:
  Mesh mesh_;
  std::vector<std::array<int, 3>> corners_;  // vertices of the mesh's triangles
};

// Of all skins of a model.
std::vector<SkinPattern> skin_patterns(const engine::ModelPtr& model);

class Extras {
 public:
  static bool any(const mjModel& model);

  Extras(const mjModel& model, const std::vector<SkinPattern>& patterns);

  // Throws Status::kRender.
  void update(const mjModel& model, const mjData& data, const render::View& view);

  int most() const { return list_.scene().maxgeom; }
  int count() const { return list_.scene().ngeom; }
  const mjvGeom& geom(int i) const { return list_.scene().geoms[i]; }
  // A skin as it lies now, and the place that it lies around.
  const Mesh& skin(int id, double* place) const;

 private:
  struct Skin {
    const SkinPattern* pattern;
    Mesh mesh;
    Vec place = Vec::Zero();
  };

  render::VisualScene list_;
  std::vector<Skin> skins_;
};

}  // namespace mimo::rays
