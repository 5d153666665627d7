#include "render/surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

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

// What the unit shape is scaled by.
std::array<float, 3> scale_of(const Shape& shape) {
  switch (shape.kind) {
    case Form::kSphere: return {shape.size[0], shape.size[0], shape.size[0]};
    case Form::kCapsule:
    case Form::kCylinder: return {shape.size[0], shape.size[0], shape.size[1]};
    default: return shape.size;
  }
}

float over(float a, float b) { return b > 0 ? a / b : 0.0F; }

}  // namespace

// As MuJoCo draws them: with texture coordinates, normals are those of the vertices; without, only where they are near
// that of the triangle.
void each_triangle_of_mesh(const Meshes& meshes, int id, const TakeTriangle& take) {
  const std::ptrdiff_t first = meshes.first_vertex[id];
  const std::ptrdiff_t first_normal = meshes.first_normal[id];
  const std::ptrdiff_t texture = meshes.first_texcoord[id];
  for (int i = 0; i < meshes.triangle_count[id]; ++i) {
    const std::ptrdiff_t at = 3 * (static_cast<std::ptrdiff_t>(meshes.first_triangle[id]) + i);
    const int *face = meshes.triangles + at, *normals = meshes.normal_triangles + at;
    const int* texels = meshes.texcoord_triangles + at;
    Corners corners;
    for (int k = 0; k < 3; ++k) {
      corners[k].place = vertex(meshes.vertices, first + face[k]);
      corners[k].normal = vertex(meshes.normals, first_normal + normals[k]);
      if (texture >= 0) std::copy_n(meshes.texcoords + 2 * (texture + texels[k]), 2, corners[k].texture.begin());
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
void each_triangle_of_field(const Fields& fields, int id, const TakeTriangle& take) {
  const int rows = fields.rows[id];
  const int columns = fields.columns[id];
  const double* size = fields.sizes + 4 * static_cast<std::ptrdiff_t>(id);
  const float* data = fields.heights + fields.first[id];
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

// OpenGL's object coordinates are those of a unit shape that is then scaled, except for prescaled ones.
TextureMapping map_texture(const Materials& materials, int material, bool cube, const Shape& shape) {
  const std::array<float, 3> scale = scale_of(shape);
  const bool uniform = materials.uniform[material] != 0;
  TextureMapping mapping;
  if (shape.given) {
    if (!cube) mapping.kind = Mapping::kGiven;
  } else if (!cube) {
    mapping.kind = Mapping::kFlat;
    for (int k = 0; k < 2; ++k) {
      float repeat = materials.repeats[2 * material + k];
      if (shape.prescaled && shape.size[k] > 0) repeat /= shape.size[k];
      if (uniform && scale[k] > 0) repeat *= scale[k];
      mapping.scale[k] = (k == 0 ? 0.5F : -0.5F) * (shape.prescaled ? repeat : over(repeat, scale[k]));
      if (materials.from_corner && scale[k] > 0) mapping.origin[k] = std::abs(mapping.scale[k]) * scale[k];
    }
  } else {
    mapping.kind = Mapping::kCube;
    for (int k = 0; k < 3; ++k) {
      const float factor = uniform ? scale[k] : 1.0F;
      mapping.scale[k] = shape.prescaled ? factor : over(factor, scale[k]);
    }
    mapping.fold = std::numeric_limits<float>::max();
    if (shape.kind == Form::kCapsule) {
      mapping.fold = shape.size[1];
      mapping.scale[3] = over(uniform ? scale[2] : 1.0F, shape.size[0]);
    }
  }
  return mapping;
}

Paint paint_of(const Materials& materials, int material, const float* rgba) {
  Paint paint;
  // MuJoCo takes an element's own colour only where it differs from the default.
  const bool is_default = rgba[0] == 0.5F && rgba[1] == 0.5F && rgba[2] == 0.5F && rgba[3] == 1.0F;
  std::copy_n(material >= 0 && is_default ? materials.colors + 4 * material : rgba, 4, paint.color.begin());
  if (material < 0) return paint;
  paint.emission = materials.emission[material];
  paint.specular = materials.specular[material];
  paint.shininess = materials.shininess[material];
  paint.reflectance = materials.reflectance[material];
  paint.texture = materials.textures[static_cast<std::ptrdiff_t>(material) * materials.texture_stride];
  return paint;
}

bool form_of(int type, Form& form) {
  switch (type) {
    case kPlaneShape: form = Form::kPlane; return true;
    case kSphereShape: form = Form::kSphere; return true;
    case kCapsuleShape: form = Form::kCapsule; return true;
    case kEllipsoidShape: form = Form::kEllipsoid; return true;
    case kCylinderShape: form = Form::kCylinder; return true;
    case kBoxShape: form = Form::kBox; return true;
    case kMeshShape:
    case kFieldShape:
    case kDistanceShape: form = Form::kMesh; return true;
    default: return false;
  }
}

}  // namespace mimo::render
