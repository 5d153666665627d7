#include "rays/frame.h"

#include "render/renderer.h"

namespace mimo::rays {

Frame::Frame(const render::Stage& stage, std::size_t extras, const Assets& assets)
    : Frame(static_cast<std::size_t>(stage.geoms.count) + static_cast<std::size_t>(stage.sites.count) + extras, stage,
            assets) {}

Frame::Frame(std::size_t most, const render::Stage& stage, const Assets& assets)
    : solids(most, assets),
      camera(most),
      lights(stage.lights, most),
      mirror(most),
      texels(assets.textures.texels()),
      textures_(assets.textures) {}

void Frame::prepare(const render::Stage& stage, const render::Poses& poses, Span<const Extra> extras,
                    const render::View& view, double aspect_ratio, const render::Quality& quality) {
  solids.gather(stage, poses, extras, view);
  camera.place(stage.air, view, aspect_ratio);
  camera.look_around(solids);
  lights.gather(stage, poses, solids, camera, quality.shadows);
  mirror.hold(solids, camera, quality.reflections);
  backdrop = backdrop_of(stage.air, textures_, solids, camera, quality);
}

}  // namespace mimo::rays
