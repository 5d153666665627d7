#include "render/texture_mapping.h"

#include <algorithm>
#include <limits>

namespace mimo::render {
namespace {

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

// OpenGL's object coordinates are those of a unit shape that is then scaled, except for prescaled ones.
TextureMapping map_texture(const mjModel& model, int material, bool cube, const Shape& shape) {
  const std::array<float, 3> scale = scale_of(shape);
  const bool uniform = model.mat_texuniform[material] != 0;
  TextureMapping mapping;
  if (shape.given) {
    if (!cube) mapping.kind = Mapping::kGiven;
  } else if (!cube) {
    mapping.kind = Mapping::kFlat;
    for (int k = 0; k < 2; ++k) {
      float repeat = model.mat_texrepeat[2 * material + k];
      if (shape.prescaled && shape.size[k] > 0) repeat /= shape.size[k];
      if (uniform && scale[k] > 0) repeat *= scale[k];
      mapping.scale[k] = (k == 0 ? 0.5F : -0.5F) * (shape.prescaled ? repeat : over(repeat, scale[k]));
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

}  // namespace mimo::render
