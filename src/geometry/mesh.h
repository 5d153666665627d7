// Shapes and the geoms of a model as triangles, and what they look like.
#pragma once

#include <mujoco/mjmodel.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "render/surfaces.h"

namespace mimo::geometry {

// Triangles as engines take them.

struct Vertex {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  Eigen::Vector2d texture = Eigen::Vector2d::Zero();
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  // three to a triangle, counter-clockwise from outside

  std::uint32_t add(const Vertex& vertex) {
    vertices.push_back(vertex);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
};

// Vertices that are alike become one.

class Welder {
 public:
  // Each three are a triangle.
  void add(const Vertex& vertex) {
    const std::array<double, 8> key = {vertex.place[0],  vertex.place[1],  vertex.place[2],   vertex.normal[0],
                                       vertex.normal[1], vertex.normal[2], vertex.texture[0], vertex.texture[1]};
    const auto [found, is_new] = known_.try_emplace(key, 0);
    if (is_new) found->second = mesh_.add(vertex);
    mesh_.indices.push_back(found->second);
  }
  Mesh take() { return std::move(mesh_); }

 private:
  Mesh mesh_;
  std::map<std::array<double, 8>, std::uint32_t> known_;
};

// Simple shapes as triangles, each in its own frame. Segments: how many straight pieces a circle becomes, a multiple of
// four.

// Upright, around the origin.
Mesh plane(double half_x, double half_y);
Mesh box(const Eigen::Vector3d& half);
Mesh ellipsoid(const Eigen::Vector3d& radii, int segments);
// Around the z axis; half: of the length, without the round ends.
Mesh capsule(double radius, double half, int segments);
Mesh cylinder(double radius, double half, int segments);

struct Detail {
  int segments;  // of a circle, a multiple of four
  double plane;  // half the length of endless planes, m
};

// In the geom's frame, with its places in the geom's texture.
Mesh mesh_of(const mjModel& model, int geom, const Detail& detail);

struct Material {
  bool visible = false;  // of the groups that MuJoCo draws, and not transparent
  int group = 0;
  render::Paint paint;
};

Material material_of(const mjModel& model, int geom);

}  // namespace mimo::geometry
