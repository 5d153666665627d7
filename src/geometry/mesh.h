// Triangles as engines take them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace mimo::geometry {

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

}  // namespace mimo::geometry
