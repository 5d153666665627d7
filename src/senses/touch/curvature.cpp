#include "senses/touch/curvature.h"

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <algorithm>
#include <cmath>

namespace mimo::senses::touch {
namespace {

constexpr double kEdge = 1e-3;  // m, radius of edges and corners of things, and how near one counts as there
constexpr double kFlat = 0.1;   // m

// How many of a box's faces a point lies at: two make an edge.
int faces_at(const Vec3& point, const double* half) {
  int faces = 0;
  for (int i = 0; i < 3; ++i) faces += std::abs(point[i]) > half[i] - kEdge ? 1 : 0;
  return faces;
}

// 1/m; 0 is flat.
double curvature(const mjModel& model, const mjData& data, const Surfaced& surface, const Vec3& point) {
  const int geom = surface.geom;
  if (geom < 0) return 0;
  const double* size = model.geom_size + 3 * geom;
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(data.geom_xmat + 9 * geom);
  const Vec3 local = frame.transpose() * (point - Vec3(data.geom_xpos + 3 * geom));
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
    case mjGEOM_CAPSULE: return 1 / size[0];
    case mjGEOM_ELLIPSOID: return 1 / std::min({size[0], size[1], size[2]});
    case mjGEOM_BOX: {
      const double edge = surface.is_flesh ? std::min({size[0], size[1], size[2]}) : kEdge;
      return faces_at(local, size) > 1 ? 1 / edge : 0;
    }
    case mjGEOM_CYLINDER: {
      const bool at_end = std::abs(local.z()) > size[1] - kEdge, at_side = local.head<2>().norm() > size[0] - kEdge;
      const double edge = surface.is_flesh ? std::min(size[0], size[1]) : kEdge;
      if (at_end) return at_side ? 1 / edge : 0;
      return 1 / size[0];
    }
    default: return 0;
  }
}

}  // namespace

double curvature_radius(const mjModel& model, const mjData& data, const Surfaced& one, const Surfaced& other,
                        const Vec3& point) {
  const double together = curvature(model, data, one, point) + curvature(model, data, other, point);
  return 1 / std::max(together, 1 / kFlat);
}

}  // namespace mimo::senses::touch
