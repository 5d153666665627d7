// What surfaces consist of and look like, as MuJoCo has it: triangles, paint, and how textures lie on them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include "render/stage.h"

namespace mimo::render {

// Products of vectors, summed from the first number to the last: Eigen sums the last two first, and pictures would then
// differ in a last digit here and there.

inline double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Eigen::Vector3d unit(const Eigen::Vector3d& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? Eigen::Vector3d(a / length) : Eigen::Vector3d(0, 0, 1);
}

// A vector as a frame sees it whose axes are these columns.
inline Eigen::Vector3d seen_from(const Eigen::Matrix3d& axes, const Eigen::Vector3d& v) {
  return {dot(axes.col(0), v), dot(axes.col(1), v), dot(axes.col(2), v)};
}

// The triangles that meshes and height fields consist of, in their own frames.

struct Corner {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  std::array<double, 2> texture{};
};
using Corners = std::array<Corner, 3>;  // counter-clockwise from outside
using TakeTriangle = std::function<void(const Corners&)>;

void each_triangle_of_mesh(const Meshes& meshes, int id, const TakeTriangle& take);
void each_triangle_of_field(const Fields& fields, int id, const TakeTriangle& take);

// How textures lie on shapes, as MuJoCo lays them.

enum class Form : std::int32_t { kPlane, kSphere, kCapsule, kEllipsoid, kCylinder, kBox, kMesh };

enum class Mapping : std::int32_t { kNone, kFlat, kCube, kGiven };  // kGiven: coordinates of a mesh

// What a texture is laid on.
struct Shape {
  Form kind;
  std::array<float, 3> size;  // as the model has it
  bool prescaled;             // drawn at its size, not as a unit shape that is scaled: geoms that are planes or meshes
  bool given;                 // has texture coordinates of its own
};

// From a place in the shape's frame to one in the texture.
struct TextureMapping {
  Mapping kind = Mapping::kNone;
  // Flat: s = scale[0] x + origin[0], t = scale[1] y + origin[1]. Cube: direction = scale * (x, y, z), where the part
  // of z beyond `fold` (the round ends of a capsule) is scaled by scale[3].
  std::array<float, 4> scale{};
  std::array<float, 2> origin{-0.5F, -0.5F};
  float fold = 0;
};

// A cube texture cannot be laid on what has coordinates of its own: kNone then.
TextureMapping map_texture(const Materials& materials, int material, bool cube, const Shape& shape);

// What something is painted with, and whether it is drawn at all, as MuJoCo has it.

struct Paint {
  std::array<float, 4> color{};
  float emission = 0;
  float specular = 0.5F;
  float shininess = 0.5F;
  float reflectance = 0;
  int texture = -1;
};

// Of a geom or site: its material (-1 for none) and its own colour.
Paint paint_of(const Materials& materials, int material, const float* rgba);

// The form of a ShapeType; false for what has none of its own.
bool form_of(int type, Form& form);

}  // namespace mimo::render
