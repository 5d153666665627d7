// What MuJoCo computes for every picture: the pieces of spatial tendons and slider-cranks, skins and flexes.
#pragma once

#include <mujoco/mjmodel.h>
#include <mujoco/mjvisualize.h>

#include <vector>

#include "base/span.h"
#include "engine/model.h"
#include "rays/solids.h"
#include "rays/surfaces.h"
#include "render/visual_scene.h"

namespace mimo::rays {

// All skins of a model, then all flexes, as they lie in its reference pose.
std::vector<MovingSurface> surfaces_of(const engine::ModelPtr& model);

class Extras {
 public:
  static bool any(const mjModel& model);

  // The surfaces are the model's, and outlive this.
  Extras(const mjModel& model, const std::vector<MovingSurface>& surfaces);

  // Throws Status::kRender.
  void update(const mjModel& model, const mjData& data, const render::View& view);

  std::size_t most() const { return most_; }
  Span<const Extra> now() const { return extras_; }

 private:
  void add(const mjModel& model, const mjData& data, const mjvGeom& geom);
  void add_skin(const mjModel& model, int id);
  void add_flex(const mjModel& model, const mjData& data, int id);
  void add_surface(std::size_t which, int material, const float* rgba);

  render::VisualScene list_;
  const std::vector<MovingSurface>& surfaces_;
  std::vector<Draped> draped_;  // of each surface
  DrawnVertices vertices_;
  std::size_t most_ = 0;
  std::vector<Extra> extras_;
};

}  // namespace mimo::rays
