#include "render/renderer.h"

#include <algorithm>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "compat/mujoco.h"
#include "render/surfaces.h"

namespace mimo::render {

double View::half_height() const { return parallel ? fovy / 2 : fixed::tan(fovy * kPi / 360); }

Pinhole pinhole_of(const View& view, double width, double height) {
  if (view.edges.given()) {
    const double focal_x = width / (view.edges.right - view.edges.left);
    const double focal_y = height / (view.edges.top - view.edges.bottom);
    return {focal_x, focal_y, -focal_x * view.edges.left, focal_y * view.edges.top};
  }
  const double focal = view.parallel ? height / view.fovy : 0.5 * height / fixed::tan(view.fovy * (kPi / 360));
  return {focal, focal, 0.5 * width, 0.5 * height, view.parallel};
}

Eigen::Vector3d project(const View& view, double width, double height, const Eigen::Vector3d& point) {
  const Eigen::Vector3d seen = seen_from(view.rotation, point - view.position);  // right, up, backward
  const Pinhole pinhole = pinhole_of(view, width, height);
  const double over = pinhole.parallel ? -1 : seen[2];
  return {pinhole.center_x - pinhole.focal_x * seen[0] / over, pinhole.center_y + pinhole.focal_y * seen[1] / over,
          -seen[2]};
}

void require_samples(std::int64_t samples) {
  const auto known = {0, 1, 4, 16, 64};
  require(std::find(known.begin(), known.end(), samples) != known.end(),
          "samples is {}, expected 1, 4, 16 or 64, or 0 for the renderer's own", samples);
}

View lens_of(const mjModel& model, int camera, double fovy) {
  View view;
  view.fovy = fovy > 0 ? fovy : model.cam_fovy[camera];
  if (fovy > 0) return view;
  view.parallel = compat::is_orthographic(model, camera);
  if (view.parallel) return view;
  const compat::Sensor sensor = compat::sensor(model, camera);
  if (!sensor.given()) return view;
  view.edges = {(sensor.principal[0] - sensor.size[0] / 2) / sensor.focal[0],
                (sensor.principal[0] + sensor.size[0] / 2) / sensor.focal[0],
                (-sensor.principal[1] - sensor.size[1] / 2) / sensor.focal[1],
                (-sensor.principal[1] + sensor.size[1] / 2) / sensor.focal[1]};
  return view;
}

View camera_view(const mjModel& model, const mjData& data, int camera, double fovy) {
  View view = lens_of(model, camera, fovy);
  view.position = Eigen::Map<const Eigen::Vector3d>(data.cam_xpos + 3 * camera);
  view.rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.cam_xmat + 9 * camera);
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
  View view = orbit_view(from.look_at, from.distance, from.azimuth, from.elevation, fovy);
  view.parallel = !(from.fovy > 0) && compat::is_free_orthographic(model);
  return view;
}

std::shared_ptr<Shelf> make_shelf() { return std::make_shared<Shelf>(); }

}  // namespace mimo::render
