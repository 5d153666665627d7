// How textures lie on shapes, as MuJoCo lays them.
#pragma once

#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>

namespace mimo::render {

enum class Form : std::int32_t { kPlane, kSphere, kCapsule, kEllipsoid, kCylinder, kBox, kMesh };

enum class Mapping : std::int32_t { kNone, kFlat, kCube, kGiven };  // kGiven: coordinates of a mesh

// What a texture is laid on.
struct Shape {
  Form kind;
  std::array<float, 3> size;  // as the model has it
  bool prescaled;             // drawn at its size, not as a unit shape that is scaled: planes and meshes of the model
  bool given;                 // has texture coordinates of its own
};

// From a place in the shape's frame to one in the texture.
struct TextureMapping {
  Mapping kind = Mapping::kNone;
  // Flat: s = scale[0] x - 1/2, t = scale[1] y - 1/2. Cube: direction = scale * (x, y, z), where the part of z beyond
  // `fold` (the round ends of a capsule) is scaled by scale[3].
  std::array<float, 4> scale{};
  float fold = 0;
};

// A cube texture cannot be laid on what has coordinates of its own: kNone then.
TextureMapping map_texture(const mjModel& model, int material, bool cube, const Shape& shape);

}  // namespace mimo::render
