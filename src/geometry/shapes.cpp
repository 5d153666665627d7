#include "geometry/shapes.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/angle.h"

namespace mimo::geometry {
namespace {

using Vec = Eigen::Vector3d;

// Two triangles between four corners, counter-clockwise from outside.
void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.add_triangle(a, b, c);
  mesh.add_triangle(a, c, d);
}

// The six sides of a cube from -1 to 1, each a grid of its own. `place` gets a place in a side, and the side's normal.
template <typename Place>
Mesh cube_grid(int pieces, Place place) {
  Mesh mesh;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1 : -1;
    const Vec normal = sign * Vec::Unit(axis);
    const Vec along = Vec::Unit((axis + 1) % 3);
    const Vec across = normal.cross(along);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto row = static_cast<std::uint32_t>(pieces) + 1;
    for (int i = 0; i <= pieces; ++i) {
      for (int j = 0; j <= pieces; ++j)
        mesh.add(place(normal, along, 2.0 * i / pieces - 1, across, 2.0 * j / pieces - 1));
    }
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      for (std::uint32_t j = 0; j + 1 < row; ++j) {
        const std::uint32_t corner = first + i * row + j;
        add_quad(mesh, corner, corner + row, corner + row + 1, corner + 1);
      }
    }
  }
  return mesh;
}

// A point of the outline that turns around the z axis.
struct Outline {
  double radius, z;
  double normal_radius, normal_z;
};

void add_ring(Mesh& mesh, const Outline& outline, int segments) {
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * kPi * i / segments;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    mesh.add({{outline.radius * c, outline.radius * s, outline.z},
              {outline.normal_radius * c, outline.normal_radius * s, outline.normal_z}});
  }
}

// From the lowest to the highest; where two follow each other at one place, there is an edge.
Mesh turned(const std::vector<Outline>& outline, int segments) {
  Mesh mesh;
  for (const Outline& ring : outline) add_ring(mesh, ring, segments);
  const auto count = static_cast<std::uint32_t>(segments);
  for (std::uint32_t ring = 0; ring + 1 < outline.size(); ++ring) {
    const Outline& low = outline[ring];
    const Outline& high = outline[ring + 1];
    if (low.radius == high.radius && low.z == high.z) continue;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = ring * count + i;
      const std::uint32_t b = ring * count + (i + 1) % count;
      if (low.radius > 0) mesh.add_triangle(a, b, b + count);
      if (high.radius > 0) mesh.add_triangle(a, b + count, a + count);
    }
  }
  return mesh;
}

}  // namespace

Mesh plane(double half_x, double half_y) {
  Mesh mesh;
  for (const double x : {-half_x, half_x}) {
    for (const double y : {-half_y, half_y}) mesh.add({{x, y, 0}, Vec::UnitZ()});
  }
  add_quad(mesh, 0, 2, 3, 1);
  return mesh;
}

Mesh box(const Vec& half) {
  return cube_grid(1, [&half](const Vec& normal, const Vec& along, double u, const Vec& across, double v) {
    return Vertex{half.cwiseProduct(normal + u * along + v * across), normal};
  });
}

// Angles rather than lengths are divided, so that triangles are of similar size.
Mesh ellipsoid(const Vec& radii, int segments) {
  const auto even = [](double u) { return std::tan(u * kPi / 4); };
  return cube_grid(segments / 4, [&](const Vec& normal, const Vec& along, double u, const Vec& across, double v) {
    const Vec place = (normal + even(u) * along + even(v) * across).normalized();
    return Vertex{place.cwiseProduct(radii), place.cwiseQuotient(radii).normalized()};
  });
}

Mesh capsule(double radius, double half, int segments) {
  std::vector<Outline> outline;
  const int quarter = segments / 4;
  for (const double end : {-1.0, 1.0}) {
    for (int i = 0; i <= quarter; ++i) {
      const double angle = kPi / 2 * (end < 0 ? i - quarter : i) / quarter;
      const bool pole = std::abs(angle) == kPi / 2;
      const double c = pole ? 0 : std::cos(angle);
      outline.push_back({radius * c, end * half + radius * std::sin(angle), c, std::sin(angle)});
    }
  }
  return turned(outline, segments);
}

Mesh cylinder(double radius, double half, int segments) {
  return turned({{0, -half, 0, -1},
                 {radius, -half, 0, -1},
                 {radius, -half, 1, 0},
                 {radius, half, 1, 0},
                 {radius, half, 0, 1},
                 {0, half, 0, 1}},
                segments);
}

}  // namespace mimo::geometry
