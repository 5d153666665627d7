#include "rays/frame.h"

#include "render/renderer.h"

namespace mimo::rays {

Frame::Frame(const mjModel& model, const Assets& assets)
    : solids(model, assets),
      camera(solids.most()),
      lights(model, solids.most()),
      mirror(solids.most()),
      texels(assets.textures.texels()),
      textures_(assets.textures) {}

void Frame::prepare(const mjModel& model, const mjData& data, const render::View& view, double aspect_ratio,
                    const render::Quality& quality) {
  solids.gather(model, data, view);
  camera.place(model, view, aspect_ratio);
  camera.look_around(solids);
  lights.gather(model, data, solids, camera, quality.shadows);
  mirror.hold(solids, camera, quality.reflections);
  backdrop = backdrop_of(model, textures_, solids, camera, quality);
}

}  // namespace mimo::rays
