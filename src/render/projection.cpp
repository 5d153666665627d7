#include "render/projection.h"

#include <cmath>

#include "base/angle.h"
#include "render/vectors.h"

namespace mimo::render {

double focal_length(double fovy, double height) { return 0.5 * height / std::tan(fovy * (kPi / 360)); }

Eigen::Vector3d project(const View& view, double width, double height, const Eigen::Vector3d& point) {
  const Eigen::Vector3d seen = seen_from(view.rotation, point - view.position);  // right, up, backward
  const double focal = focal_length(view.fovy, height);
  return {0.5 * width - focal * seen[0] / seen[2], 0.5 * height + focal * seen[1] / seen[2], -seen[2]};
}

}  // namespace mimo::render
