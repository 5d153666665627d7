#include "senses/touch/shape.h"

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "base/span.h"
#include "base/turns.h"
#include "engine/physics.h"

namespace mimo::senses::touch {
namespace {

// A point on the seam of two geoms must not vanish from both because of rounding.
constexpr double kTolerance = 1e-9;  // m

double distance_to_axis(const Vec3& point, double half_length) {
  const double beyond = std::max(std::abs(point.z()) - half_length, 0.0);
  return length_of(point.x(), point.y(), beyond);
}

// Depth below an ellipsoid's surface, exact to first order where it matters: at the surface.
double ellipsoid_depth(const Vec3& radii, const Vec3& point) {
  const Vec3 scaled = point.cwiseQuotient(radii);
  const double slope = 2 * scaled.cwiseQuotient(radii).norm();
  const double level = 1 - scaled.squaredNorm();
  return slope > 0 ? level / slope : radii.minCoeff();
}

// How deep a point lies below the surface; negative outside. Exact near the surface.
double depth(const OuterShape& shape, const Vec3& point) {
  const Vec3& size = shape.size;
  switch (shape.form) {
    case OuterShape::Form::kNone: return -1;
    case OuterShape::Form::kSphere: return size.x() - point.norm();
    case OuterShape::Form::kCapsule: return size.x() - distance_to_axis(point, size.y());
    case OuterShape::Form::kCylinder:
      return std::min(size.x() - length_of(point.x(), point.y()), size.y() - std::abs(point.z()));
    case OuterShape::Form::kBox: return (size - point.cwiseAbs()).minCoeff();
    case OuterShape::Form::kEllipsoid: return ellipsoid_depth(size, point);
    case OuterShape::Form::kMesh: return shape.hull->depth(point);
  }
  return -1;
}

// Corners of the hull's triangles, as mesh_graph has them: two counts, for each of the hull's points where its edges
// begin and its number in the mesh, the edges, and the triangles.
Span<const int> hull_corners(const mjModel& model, int mesh) {
  const int* graph = model.mesh_graph + model.mesh_graphadr[mesh];
  const int points = graph[0], triangles = graph[1];
  return {graph + 2 + 2 * points + points + 3 * triangles, static_cast<std::size_t>(3 * triangles)};
}

Span<const int> own_corners(const mjModel& model, int mesh) {
  return {model.mesh_face + 3 * model.mesh_faceadr[mesh], static_cast<std::size_t>(3 * model.mesh_facenum[mesh])};
}

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

bool has_shape(const mjModel& model, int geom) {
  return model.geom_type[geom] != mjGEOM_PLANE && model.geom_type[geom] != mjGEOM_HFIELD;
}

OuterShape shape_of(const mjModel& model, int geom) {
  const Vec3 size(model.geom_size + 3 * geom);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE: return {OuterShape::Form::kSphere, size};
    case mjGEOM_CAPSULE: return {OuterShape::Form::kCapsule, size};
    case mjGEOM_CYLINDER: return {OuterShape::Form::kCylinder, size};
    case mjGEOM_BOX: return {OuterShape::Form::kBox, size};
    case mjGEOM_ELLIPSOID: return {OuterShape::Form::kEllipsoid, size};
    case mjGEOM_MESH:
      return {OuterShape::Form::kMesh, Vec3::Zero(),
              std::make_shared<const Hull>(hull_of(model, model.geom_dataid[geom]))};
    default: return {};
  }
}

Eigen::Matrix3d rotation_of(const mjModel& model, int geom) {
  const double* quat = model.geom_quat + 4 * geom;
  return normal_turn(Eigen::Quaterniond(quat[0], quat[1], quat[2], quat[3])).toRotationMatrix();
}

bool inside(const OuterShape& shape, const Vec3& point) { return depth(shape, point) > kTolerance; }

double Hull::area() const {
  double sum = 0;
  for (const Triangle& triangle : triangles) sum += triangle.area;
  return sum;
}

double Hull::depth(const Vec3& point) const {
  if (!closed || triangles.empty()) return -1;
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : triangles) least = std::min(least, triangle.normal.dot(triangle.corner - point));
  return least;
}

Hull hull_of(const mjModel& model, int mesh) {
  Hull hull;
  hull.closed = model.mesh_graphadr[mesh] >= 0;
  const Span<const int> corners = hull.closed ? hull_corners(model, mesh) : own_corners(model, mesh);
  const float* points = model.mesh_vert + 3 * model.mesh_vertadr[mesh];
  const auto point = [&](std::size_t corner) -> Vec3 {
    return Eigen::Map<const Eigen::Vector3f>(points + 3 * corners[corner]).cast<double>();
  };
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) middle += point(i) / static_cast<double>(corners.size());
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Vec3 corner = point(i), first = point(i + 1) - corner, second = point(i + 2) - corner;
    const Vec3 across = first.cross(second);
    if (across.norm() == 0) continue;
    const bool inward = hull.closed && across.dot(corner - middle) < 0;
    hull.triangles.push_back({corner, first, second, (inward ? -1 : 1) * across.normalized(), across.norm() / 2});
  }
  return hull;
}

double curvature_radius(const mjModel& model, const mjData& data, const Surfaced& one, const Surfaced& other,
                        const Vec3& point) {
  const double together = curvature(model, data, one, point) + curvature(model, data, other, point);
  return 1 / std::max(together, 1 / kFlat);
}

}  // namespace mimo::senses::touch
