#include "render/renderer.h"

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <algorithm>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "render/surfaces.h"

namespace mimo::render {

double focal_length(double fovy, double height) { return 0.5 * height / fixed::tan(fovy * (kPi / 360)); }

Eigen::Vector3d project(const View& view, double width, double height, const Eigen::Vector3d& point) {
  const Eigen::Vector3d seen = seen_from(view.rotation, point - view.position);  // right, up, backward
  const double focal = focal_length(view.fovy, height);
  return {0.5 * width - focal * seen[0] / seen[2], 0.5 * height + focal * seen[1] / seen[2], -seen[2]};
}

void require_samples(std::int64_t samples) {
  const auto known = {0, 1, 4, 16, 64};
  require(std::find(known.begin(), known.end(), samples) != known.end(),
          "samples is {}, expected 1, 4, 16 or 64, or 0 for the renderer's own", samples);
}

View camera_view(const mjModel& model, const mjData& data, int camera, double fovy) {
  View view;
  view.position = Eigen::Map<const Eigen::Vector3d>(data.cam_xpos + 3 * camera);
  view.rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.cam_xmat + 9 * camera);
  view.fovy = fovy > 0 ? fovy : model.cam_fovy[camera];
  return view;
}

View orbit_view(const Eigen::Vector3d& look_at, double distance, double azimuth, double elevation, double fovy) {
  const double sin_a = fixed::sin(azimuth * kPi / 180), cos_a = fixed::cos(azimuth * kPi / 180);
  const double sin_e = fixed::sin(elevation * kPi / 180), cos_e = fixed::cos(elevation * kPi / 180);
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

std::shared_ptr<Shelf> make_shelf() { return std::make_shared<Shelf>(); }

}  // namespace mimo::render
