// Shapes as triangles: closed, turned outwards, on the surface, and with the volumes of geometry books.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/mesh.h"

namespace mimo::geometry {
namespace {

using Vec = Eigen::Vector3d;
constexpr double kPi = 3.14159265358979323846;

double volume(const Mesh& mesh) {
  double six = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec& a = mesh.vertices[mesh.indices[i]].place;
    const Vec& b = mesh.vertices[mesh.indices[i + 1]].place;
    const Vec& c = mesh.vertices[mesh.indices[i + 2]].place;
    six += a.dot(b.cross(c));
  }
  return six / 6;
}

// Each edge is gone along as often in one direction as in the other; vertices at one place count as one.
bool closed(const Mesh& mesh) {
  using Place = std::array<long, 3>;
  const auto place = [&mesh](std::uint32_t i) {
    const Vec p = 1e9 * mesh.vertices[i].place;
    return Place{std::lround(p[0]), std::lround(p[1]), std::lround(p[2])};
  };
  std::map<std::pair<Place, Place>, int> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Place from = place(mesh.indices[i + k]);
      const Place to = place(mesh.indices[i + (k + 1) % 3]);
      from < to ? ++edges[{from, to}] : --edges[{to, from}];
    }
  }
  for (const auto& [edge, count] : edges) {
    if (count != 0) return false;
  }
  return !edges.empty();
}

// Normals are of length 1 and to the side to which the triangles show.
void expect_outward(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex* corners[3];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = &mesh.vertices[mesh.indices[i + k]];
    const Vec flat = (corners[1]->place - corners[0]->place).cross(corners[2]->place - corners[0]->place).normalized();
    for (const Vertex* corner : corners) {
      ASSERT_NEAR(corner->normal.norm(), 1, 1e-12);
      ASSERT_GT(corner->normal.dot(flat), 0.8);
    }
  }
}

TEST(GeometryShapes, ABoxIsExact) {
  const Mesh mesh = box({0.1, 0.2, 0.3});
  EXPECT_TRUE(closed(mesh));
  expect_outward(mesh);
  EXPECT_NEAR(volume(mesh), 0.2 * 0.4 * 0.6, 1e-15);
  EXPECT_EQ(box({1, 1, 1}).indices.size(), 36U);
}

// The error of a circle of n pieces is (2 pi / n)^2 / 6 of its area, that of a sphere about twice as large.
TEST(GeometryShapes, RoundOnesHaveTheirVolume) {
  const double r = 0.3, h = 0.5;
  const struct {
    Mesh mesh;
    double volume;
  } shapes[] = {
      {ellipsoid({0.2, 0.3, 0.4}, 64), 4 * kPi / 3 * 0.2 * 0.3 * 0.4},
      {capsule(r, h, 64), 2 * h * kPi * r * r + 4 * kPi / 3 * r * r * r},
      {cylinder(r, h, 64), 2 * h * kPi * r * r},
  };
  for (const auto& shape : shapes) {
    EXPECT_TRUE(closed(shape.mesh));
    expect_outward(shape.mesh);
    EXPECT_LT(volume(shape.mesh), shape.volume);
    EXPECT_NEAR(volume(shape.mesh) / shape.volume, 1, 0.005);
  }
}

TEST(GeometryShapes, VerticesLieOnTheSurface) {
  for (const Vertex& vertex : ellipsoid({0.2, 0.3, 0.4}, 16).vertices) {
    EXPECT_NEAR(vertex.place.cwiseQuotient(Vec(0.2, 0.3, 0.4)).norm(), 1, 1e-12);
  }
  for (const Vertex& vertex : capsule(0.3, 0.5, 16).vertices) {
    const Vec axis(0, 0, std::min(std::max(vertex.place[2], -0.5), 0.5));
    EXPECT_NEAR((vertex.place - axis).norm(), 0.3, 1e-12);
    EXPECT_LT(((vertex.place - axis) / 0.3 - vertex.normal).norm(), 1e-9);
  }
}

TEST(GeometryShapes, PlanesFaceUp) {
  const Mesh mesh = plane(2, 3);
  expect_outward(mesh);
  ASSERT_EQ(mesh.indices.size(), 6U);
  double high = 0;
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_EQ(vertex.normal, Vec::UnitZ());
    high = std::max(high, vertex.place[1]);
  }
  EXPECT_EQ(high, 3);
}

TEST(GeometryShapes, DetailIsChosen) {
  EXPECT_EQ(cylinder(1, 1, 8).indices.size() / 3, 32U);  // two fans of 8 and 8 quads
  EXPECT_EQ(capsule(1, 1, 8).indices.size() / 3, 64U);   // 8 quads around, two caps of 8 quads and 8 triangles
  EXPECT_EQ(ellipsoid({1, 1, 1}, 8).indices.size() / 3, 48U);
}

}  // namespace
}  // namespace mimo::geometry
