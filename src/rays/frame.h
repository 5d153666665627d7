// One picture's scene as the kernels see it: every geom, light and eye brought into the form in which casting a ray is
// cheapest. It is the sum of what its makers give.
#pragma once

#include "rays/backdrop.h"
#include "rays/camera.h"
#include "rays/lights.h"
#include "rays/mirror.h"
#include "rays/solids.h"

namespace mimo::rays {

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
