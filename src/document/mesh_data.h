// What is in a mesh's file, as far as it must be right: vertices, faces, and whether they span a convex hull.
#pragma once

#include <array>
#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "document/budget.h"
#include "document/files.h"

namespace mimo::document {

// Whether points span a space.

// Whether all points lie in one plane, except for about ten roundings of their coordinates, which are floats.
bool is_flat(const std::vector<std::array<double, 3>>& points);

// Convex hulls, as far as one can tell of them before MuJoCo makes them.

// How many corners the convex hull of points has, at most: of many points, as many in proportion as that of some of
// them, for what is a corner among all is one among fewer. The points must not be flat.
double hull_corners(std::vector<std::array<double, 3>> points);

// The vertices that MuJoCo keeps of a mesh's file with faces of many corners: it leaves out what it cannot cut into
// triangles. Throws Status::kModel where it cannot read the file.
std::vector<std::array<double, 3>> kept_vertices(pugi::xml_node mesh, const Limits& limits);

// What there is in a file of a mesh, as far as it must be right: where vertices are, and what faces refer to.

struct MeshData {
  std::vector<std::array<double, 3>> vertices;  // those that the mesh uses
  bool has_faces = false;
  double kept = 0;  // vertices that MuJoCo keeps of them, which may be more
  double file_bytes = 0;
  double polygons = 0;  // faces of more than four corners: the sum of the squares of how many they have
};

// Read .stl, .msh and .obj as MuJoCo does. They refuse files with counts that lie, with indices that are out of range,
// with more than the limits allow.
MeshData read_stl(const LoadedFile& file, const Limits& limits);
MeshData read_msh(const LoadedFile& file, const Limits& limits);
MeshData read_obj(const LoadedFile& file, const Limits& limits);

void require_few(const LoadedFile& file, double count, const char* what, const Limits& limits);

}  // namespace mimo::document
