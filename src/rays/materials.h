// What solids are made of, in the terms of the kernels.
#pragma once

#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>

#include "rays/textures.h"

namespace mimo::rays {

enum class Form : std::int32_t { kPlane, kSphere, kCapsule, kEllipsoid, kCylinder, kBox, kMesh };

enum class Mapping : std::int32_t { kNone, kFlat, kCube, kGiven };  // kGiven: coordinates of a mesh

// x^exponent for x in 0..1: by repeated squaring where the exponent is whole or so large that it may be rounded, which
// changes the result by less than 1 / 40.
struct Power {
  float exponent = 0;
  std::int32_t whole = 0;  // the rounded exponent, -1 where it must not be rounded
};

struct Material {
  std::array<float, 3> rgb{};
  float alpha = 1;
  std::array<float, 3> emission{};
  float specular = 0;
  float reflectance = 0;
  Power shininess;
  const Texture* texture = nullptr;
  Mapping mapping = Mapping::kNone;
  // Flat: s = scale[0] x - 1/2, t = scale[1] y - 1/2. Cube: direction = scale * (x, y, z), where the part of z beyond
  // `fold` (the round ends of a capsule) is scaled by scale[3].
  std::array<float, 4> scale{};
  float fold = 0;
};

Power power(double exponent);

// What a texture is laid on.
struct Shape {
  Form kind;
  std::array<float, 3> size;  // as the model has it
  bool prescaled;             // drawn at its size, not as a unit shape that is scaled: planes and meshes of the model
  bool given;                 // has texture coordinates of its own
};

// Of a geom or site: its material (-1 for none) and its own colour.
Material material_of(const mjModel& model, int id, const float* rgba, const Shape& shape, const Textures& textures);

}  // namespace mimo::rays
