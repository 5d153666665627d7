// What MuJoCo works out anew for every picture: the pieces of spatial tendons and of slider-cranks, and skins.
#pragma once

#include <mujoco/mjmodel.h>
#include <mujoco/mjvisualize.h>

#include <vector>

#include "rays/skins.h"
#include "render/visual_scene.h"

namespace mimo::rays {

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
