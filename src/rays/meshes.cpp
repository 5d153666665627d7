#include "rays/meshes.h"

#include <algorithm>

#include "rays/mesh_builder.h"
#include "rays/vectors.h"

namespace mimo::rays {
namespace {

// As MuJoCo draws them: with texture coordinates, normals are those of the vertices; without, only where they are near
// that of the triangle.
Mesh mesh_of(const mjModel& model, int id) {
  const int first = model.mesh_vertadr[id];
  const int texture = model.mesh_texcoordadr[id];
  MeshBuilder builder(model.mesh_facenum[id]);
  for (int i = 0; i < model.mesh_facenum[id]; ++i) {
    const int* face = model.mesh_face + 3 * (static_cast<std::ptrdiff_t>(model.mesh_faceadr[id]) + i);
    Corners corners;
    for (int k = 0; k < 3; ++k) {
      const std::ptrdiff_t vertex = first + face[k];
      corners[k].place = Eigen::Map<const Eigen::Vector3f>(model.mesh_vert + 3 * vertex).cast<double>();
      corners[k].normal = Eigen::Map<const Eigen::Vector3f>(model.mesh_normal + 3 * vertex).cast<double>();
      if (texture >= 0) {
        const float* place = model.mesh_texcoord + 2 * (static_cast<std::ptrdiff_t>(texture) + face[k]);
        std::copy_n(place, 2, corners[k].texture.begin());
      }
    }
    if (texture < 0) {
      const Vec flat = normal_of(corners);
      for (Corner& corner : corners) {
        if (dot(corner.normal, flat) < 0.8) corner.normal = flat;
      }
    }
    builder.add(corners);
  }
  return builder.finish(texture >= 0);
}

// The surface, four sides and the bottom.
Mesh field_of(const mjModel& model, int id) {
  const int rows = model.hfield_nrow[id];
  const int columns = model.hfield_ncol[id];
  const double* size = model.hfield_size + 4 * static_cast<std::ptrdiff_t>(id);
  const float* data = model.hfield_data + model.hfield_adr[id];
  const auto at = [=](int row, int column) {
    return Vec(size[0] * (2.0 * column / (columns - 1) - 1), size[1] * (2.0 * row / (rows - 1) - 1),
               size[2] * data[static_cast<std::ptrdiff_t>(row) * columns + column]);
  };
  const auto below = [=](const Vec& p) { return Vec(p[0], p[1], -size[3]); };
  MeshBuilder builder(2.0 * (rows + 1) * (columns + 1));
  const auto wall = [&](const Vec& a, const Vec& b) {  // with its inside to the left of the way from a to b
    builder.add_flat(a, below(a), below(b));
    builder.add_flat(a, below(b), b);
  };
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      builder.add_flat(at(row + 1, column), at(row, column), at(row + 1, column + 1));
      builder.add_flat(at(row, column), at(row, column + 1), at(row + 1, column + 1));
    }
    wall(at(row + 1, 0), at(row, 0));
    wall(at(row, columns - 1), at(row + 1, columns - 1));
  }
  for (int column = 0; column + 1 < columns; ++column) {
    wall(at(0, column), at(0, column + 1));
    wall(at(rows - 1, column + 1), at(rows - 1, column));
  }
  const Vec corners[4] = {below(at(0, 0)), below(at(rows - 1, 0)), below(at(rows - 1, columns - 1)),
                          below(at(0, columns - 1))};
  builder.add_flat(corners[0], corners[1], corners[2]);
  builder.add_flat(corners[0], corners[2], corners[3]);
  return builder.finish(false);
}

}  // namespace

Meshes::Meshes(const mjModel& model) {
  for (int i = 0; i < model.nmesh; ++i) meshes_.push_back(mesh_of(model, i));
  for (int i = 0; i < model.nhfield; ++i) fields_.push_back(field_of(model, i));
}

const Mesh* Meshes::find(int geom_type, int data_id) const {
  if (geom_type != mjGEOM_MESH && geom_type != mjGEOM_HFIELD) return nullptr;
  const std::vector<Mesh>& all = geom_type == mjGEOM_MESH ? meshes_ : fields_;
  return data_id >= 0 && data_id < static_cast<int>(all.size()) ? &all[data_id] : nullptr;
}

}  // namespace mimo::rays
