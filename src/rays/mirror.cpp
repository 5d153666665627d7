#include "rays/mirror.h"

namespace mimo::rays {

Mirror::Mirror(std::size_t most) { eye.aspects.resize(most); }

void Mirror::hold(const Solids& solids, const Camera& camera, bool reflections) {
  eye.count = 0;
  solid = -1;
  if (solids.mirror() < 0 || !reflections) return;
  const Solid& glass = solids[solids.mirror()];
  const Vec normal = glass.rotation.col(2);
  Vec point = glass.position;
  if (glass.kind == Form::kBox) point += static_cast<double>(glass.size[2]) * normal;
  const double height = dot(camera.position - point, normal);
  if (height < 0) return;
  solid = solids.mirror();
  reflectance = glass.material.reflectance;
  eye.position = camera.position + -2 * height * normal;
  for (int k = 0; k < 3; ++k) eye.axes.col(k) = camera.axes.col(k) + -2 * dot(camera.axes.col(k), normal) * normal;
  eye.reach = camera.reach;
  eye.wide = camera.wide;
  eye.high = camera.high;
  for (int i = 0; i < solids.count(); ++i) {
    // Only what rises above the mirror shows in it.
    const Solid& other = solids[i];
    if (i == solid) continue;
    if (other.kind != Form::kPlane && dot(other.position - point, normal) < -other.radius) continue;
    eye.look_at(other, i, camera.near_plane);
  }
}

}  // namespace mimo::rays
