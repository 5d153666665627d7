#include "rays/camera.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "render/renderer.h"

namespace mimo::rays {

Camera::Camera(std::size_t most) : seen(most), transparent(most) { aspects.resize(most); }

void Camera::place(const mjModel& model, const render::View& view, double aspect_ratio) {
  near_plane = static_cast<float>(model.vis.map.znear * model.stat.extent);
  far_plane = static_cast<float>(model.vis.map.zfar * model.stat.extent);
  position = view.position;
  axes = view.rotation;
  axes.col(2) = -axes.col(2);
  reach = far_plane;
  high = std::tan(view.fovy * kPi / 360);
  wide = high * aspect_ratio;
}

void Camera::look_around(const Solids& solids) {
  count = 0;
  transparent_count = 0;
  for (int i = 0; i < solids.count(); ++i) look_at(solids[i], i, near_plane);
  std::fill(seen.begin(), seen.end(), -2);
  for (int i = 0; i < count; ++i) {
    seen[aspects[i].solid] = i;
    if (solids[aspects[i].solid].transparent) transparent[transparent_count++] = i;
  }
  std::sort(transparent.begin(), transparent.begin() + transparent_count, [&](int a, int b) {
    const int i = aspects[a].solid;
    const int j = aspects[b].solid;
    return solids[i].order != solids[j].order ? solids[i].order < solids[j].order : i < j;
  });
}

}  // namespace mimo::rays
