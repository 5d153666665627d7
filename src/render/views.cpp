#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <cmath>

#include "base/angle.h"
#include "render/viewpoint.h"

namespace mimo::render {

View camera_view(const mjModel& model, const mjData& data, int camera, double fovy) {
  View view;
  view.position = Eigen::Map<const Eigen::Vector3d>(data.cam_xpos + 3 * camera);
  view.rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.cam_xmat + 9 * camera);
  view.fovy = fovy > 0 ? fovy : model.cam_fovy[camera];
  return view;
}

View orbit_view(const Eigen::Vector3d& look_at, double distance, double azimuth, double elevation, double fovy) {
  const double sin_a = std::sin(azimuth * kPi / 180), cos_a = std::cos(azimuth * kPi / 180);
  const double sin_e = std::sin(elevation * kPi / 180), cos_e = std::cos(elevation * kPi / 180);
  const Eigen::Vector3d forward(cos_e * cos_a, cos_e * sin_a, sin_e);
  View view;
  view.position = look_at - distance * forward;
  view.rotation.col(0) << sin_a, -cos_a, 0;
  view.rotation.col(1) << -sin_e * cos_a, -sin_e * sin_a, cos_e;
  view.rotation.col(2) = -forward;
  view.fovy = fovy;
  return view;
}

View view_from(const mjModel& model, const mjData& data, const Viewpoint& from) {
  if (from.camera >= 0) return camera_view(model, data, from.camera, from.fovy);
  const double fovy = from.fovy > 0 ? from.fovy : static_cast<double>(model.vis.global.fovy);
  return orbit_view(from.look_at, from.distance, from.azimuth, from.elevation, fovy);
}

}  // namespace mimo::render
