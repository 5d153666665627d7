#include "senses/touch/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "base/span.h"
#include "engine/physics.h"

namespace mimo::senses::touch {
namespace {

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

}  // namespace

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

}  // namespace mimo::senses::touch
