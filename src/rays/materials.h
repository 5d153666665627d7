// What solids are made of, in the terms of the kernels.
#pragma once

#include <mujoco/mjmodel.h>

#include <array>
#include <cstdint>

#include "rays/textures.h"
#include "render/texture_mapping.h"

namespace mimo::rays {

using render::Form;
using render::Mapping;

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
  render::TextureMapping mapping;
};

Power power(double exponent);

// Of a geom or site: its material (-1 for none) and its own colour.
Material material_of(const mjModel& model, int id, const float* rgba, const render::Shape& shape,
                     const Textures& textures);

}  // namespace mimo::rays
