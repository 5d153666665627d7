#include "render/triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

#include "compat/mujoco.h"
#include "render/vectors.h"

namespace mimo::render {
namespace {

using Vec = Eigen::Vector3d;

Vec normal_of(const Corners& corners) {
  const Vec e1 = corners[1].place - corners[0].place;
  const Vec e2 = corners[2].place - corners[0].place;
  return unit(e1.cross(e2));
}

Corners flat(const Vec& a, const Vec& b, const Vec& c) {
  Corners corners;
  corners[0].place = a;
  corners[1].place = b;
  corners[2].place = c;
  for (Corner& corner : corners) corner.normal = normal_of(corners);
  return corners;
}

Vec vertex(const float* of, std::ptrdiff_t i) { return Eigen::Map<const Eigen::Vector3f>(of + 3 * i).cast<double>(); }

}  // namespace

// As MuJoCo draws them: with texture coordinates, normals are those of the vertices; without, only where they are near
// that of the triangle.
void each_triangle_of_mesh(const mjModel& model, int id, const TakeTriangle& take) {
  const std::ptrdiff_t first = model.mesh_vertadr[id];
  const std::ptrdiff_t texture = model.mesh_texcoordadr[id];
  for (int i = 0; i < model.mesh_facenum[id]; ++i) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(model.mesh_faceadr[id]) + i;
    const int *face = model.mesh_face + 3 * at, *normals = compat::face_normals(model, at);
    const int* texels = compat::face_texcoords(model, at);
    Corners corners;
    for (int k = 0; k < 3; ++k) {
      corners[k].place = vertex(model.mesh_vert, first + face[k]);
      corners[k].normal = vertex(model.mesh_normal, compat::first_normal(model, id) + normals[k]);
      if (texture >= 0) std::copy_n(model.mesh_texcoord + 2 * (texture + texels[k]), 2, corners[k].texture.begin());
    }
    if (texture < 0) {
      const Vec normal = normal_of(corners);
      for (Corner& corner : corners) {
        if (dot(corner.normal, normal) < 0.8) corner.normal = normal;
      }
    }
    take(corners);
  }
}

// The surface, four sides and the bottom.
void each_triangle_of_field(const mjModel& model, int id, const TakeTriangle& take) {
  const int rows = model.hfield_nrow[id];
  const int columns = model.hfield_ncol[id];
  const double* size = model.hfield_size + 4 * static_cast<std::ptrdiff_t>(id);
  const float* data = model.hfield_data + model.hfield_adr[id];
  const auto at = [=](int row, int column) {
    return Vec(size[0] * (2.0 * column / (columns - 1) - 1), size[1] * (2.0 * row / (rows - 1) - 1),
               size[2] * data[static_cast<std::ptrdiff_t>(row) * columns + column]);
  };
  const auto below = [=](const Vec& p) { return Vec(p[0], p[1], -size[3]); };
  const auto wall = [&](const Vec& a, const Vec& b) {  // with its inside to the left of the way from a to b
    take(flat(a, below(a), below(b)));
    take(flat(a, below(b), b));
  };
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      take(flat(at(row + 1, column), at(row, column), at(row + 1, column + 1)));
      take(flat(at(row, column), at(row, column + 1), at(row + 1, column + 1)));
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
  take(flat(corners[0], corners[1], corners[2]));
  take(flat(corners[0], corners[2], corners[3]));
}

}  // namespace mimo::render
