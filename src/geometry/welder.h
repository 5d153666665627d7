// Vertices that are alike become one.
#pragma once

#include <array>
#include <map>
#include <utility>

#include "geometry/mesh.h"

namespace mimo::geometry {

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

}  // namespace mimo::geometry
