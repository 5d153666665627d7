// What the compiler makes of meshes, asked of models that have nothing else.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace mimo::engine {

// How many corners the convex hull of points has, which must not be flat.
int hull_corners(const std::vector<std::array<double, 3>>& points);

// The vertices of a mesh's file, "mesh.obj", as they are in there. Throws what compile throws.
std::vector<std::array<double, 3>> vertices_of(const std::string& name, const std::string& bytes);

}  // namespace mimo::engine
