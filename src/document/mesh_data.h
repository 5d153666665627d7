// What there is in a file of a mesh, as far as it must be right: where vertices are, and what faces refer to.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "document/limits.h"
#include "document/loaded_file.h"

namespace mimo::document {

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
