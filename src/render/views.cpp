#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <algorithm>
#include <cmath>

#include "render/renderer.h"

namespace mimo::render {

View camera_view(const mjModel& model, const mjData& data, int camera, double fovy) {
  View view;
  std::copy_n(data.cam_xpos + 3 * camera, 3, view.position.begin());
  std::copy_n(data.cam_xmat + 9 * camera, 9, view.rotation.begin());
  view.fovy = fovy > 0 ? fovy : model.cam_fovy[camera];
  return view;
}

View orbit_view(const std::array<double, 3>& look_at, double distance, double azimuth, double elevation, double fovy) {
  const double sin_a = std::sin(azimuth * mjPI / 180), cos_a = std::cos(azimuth * mjPI / 180);
  const double sin_e = std::sin(elevation * mjPI / 180), cos_e = std::cos(elevation * mjPI / 180);
  const std::array<double, 3> forward = {cos_e * cos_a, cos_e * sin_a, sin_e};
  View view;
  for (std::size_t i = 0; i < 3; ++i) view.position[i] = look_at[i] - distance * forward[i];
  view.rotation = {sin_a,  -sin_e * cos_a, -forward[0],  //
                   -cos_a, -sin_e * sin_a, -forward[1],  //
                   0,      cos_e,          -forward[2]};
  view.fovy = fovy;
  return view;
}

}  // namespace mimo::render
