#include "rays/backdrop.h"

#include <cmath>

#include "base/functions.h"
#include "base/numbers.h"
#include "render/renderer.h"
#include "render/stage.h"

namespace mimo::rays {
namespace {

Sky sky_of(const Texture* texture, const Camera& camera) {
  Sky sky;
  sky.texture = texture;
  if (texture == nullptr) return sky;
  // MuJoCo's sky is a box map turned by 90 degrees about x.
  const auto turned = [](const Vec& v) { return narrow({v[0], v[2], -v[1]}); };
  sky.limit = 0.7F * camera.far_plane;
  // Parallel rays are so many metres beside the eye, and all of their sky lies far ahead.
  if (camera.rays == Rays::kParallel) sky.step = 1 / sky.limit;
  sky.a = turned(camera.axes.col(2));
  sky.bx = turned(sky.step * camera.axes.col(0));
  sky.by = turned(sky.step * camera.axes.col(1));
  return sky;
}

Haze haze_over(const Solid& plane, const render::Air& air, const Sky& sky, const Camera& camera) {
  const double height = dot(camera.position - plane.position, plane.rotation.col(2));
  const double r = air.haze;
  Haze haze;
  haze.shown = height >= 0 && r > 0;
  haze.a = narrow(to_local(plane, camera.axes.col(2)));
  haze.bx = narrow(to_local(plane, sky.step * camera.axes.col(0)));
  haze.by = narrow(to_local(plane, sky.step * camera.axes.col(1)));
  haze.elevation = static_cast<float>(height / sky.limit);
  haze.radius = static_cast<float>(r);
  const double alpha = fixed::atan2(1, r);
  const double beta = 0.75 * kPi - alpha;
  haze.turn = static_cast<float>(std::sqrt(0.5) * r * fixed::sin(alpha) / fixed::sin(beta));
  haze.rgb = three(air.haze_color);
  return haze;
}

Fog fog_of(const render::Air& air) {
  Fog fog;
  fog.shown = true;
  fog.rgb = three(air.fog_color);
  fog.start = static_cast<float>(air.fog_start);
  fog.scale = static_cast<float>(air.fog_length > 0 ? 1 / air.fog_length : 0);
  return fog;
}

}  // namespace

Backdrop backdrop_of(const render::Air& air, const Textures& textures, const Solids& solids, const Camera& camera,
                     const render::Quality& quality) {
  Backdrop backdrop;
  backdrop.sky = sky_of(quality.skybox ? textures.sky() : nullptr, camera);
  const bool horizon = solids.ground() >= 0 && !solids[solids.ground()].transparent;
  if (backdrop.sky.texture != nullptr && quality.haze && horizon) {
    backdrop.haze = haze_over(solids[solids.ground()], air, backdrop.sky, camera);
  }
  if (quality.fog) backdrop.fog = fog_of(air);
  return backdrop;
}

}  // namespace mimo::rays
