#include "rays/materials.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rays/vectors.h"

namespace mimo::rays {
namespace {

// OpenGL's object coordinates are those of a unit shape that is then scaled, except for prescaled ones.
void map_texture(const mjModel& model, int id, const Shape& shape, Material& material) {
  const std::array<float, 3>& size = shape.size;
  const bool uniform = model.mat_texuniform[id] != 0;
  float scale[3];  // what the unit shape is scaled by
  switch (shape.kind) {
    case Form::kSphere: scale[0] = scale[1] = scale[2] = size[0]; break;
    case Form::kCapsule:
    case Form::kCylinder:
      scale[0] = scale[1] = size[0];
      scale[2] = size[1];
      break;
    default: std::copy(size.begin(), size.end(), scale); break;
  }
  const auto over = [](float a, float b) { return b > 0 ? a / b : 0.0F; };
  if (shape.given) {
    // Only a flat texture can be laid on them.
    if (material.texture->cube)
      material.texture = nullptr;
    else
      material.mapping = Mapping::kGiven;
  } else if (!material.texture->cube) {
    material.mapping = Mapping::kFlat;
    for (int k = 0; k < 2; ++k) {
      float repeat = model.mat_texrepeat[2 * id + k];
      if (shape.prescaled && size[k] > 0) repeat /= size[k];
      if (uniform && scale[k] > 0) repeat *= scale[k];
      material.scale[k] = (k == 0 ? 0.5F : -0.5F) * (shape.prescaled ? repeat : over(repeat, scale[k]));
    }
  } else {
    material.mapping = Mapping::kCube;
    for (int k = 0; k < 3; ++k) {
      const float factor = uniform ? scale[k] : 1.0F;
      material.scale[k] = shape.prescaled ? factor : over(factor, scale[k]);
    }
    material.fold = std::numeric_limits<float>::max();
    if (shape.kind == Form::kCapsule) {
      material.fold = size[1];
      material.scale[3] = over(uniform ? scale[2] : 1.0F, size[0]);
    }
  }
}

}  // namespace

Power power(double exponent) {
  Power p;
  p.exponent = static_cast<float>(exponent);
  const double rounded = std::round(std::min(exponent, 1e9));  // from there on, it is all the same
  const bool whole = std::abs(rounded - exponent) < 1e-4 || exponent > 8;
  p.whole = whole ? static_cast<std::int32_t>(rounded) : -1;
  return p;
}

Material material_of(const mjModel& model, int id, const float* rgba, const Shape& shape, const Textures& textures) {
  Material material;
  const float* color = rgba;
  // MuJoCo takes an element's own colour only where it differs from the default.
  const bool is_default = rgba[0] == 0.5F && rgba[1] == 0.5F && rgba[2] == 0.5F && rgba[3] == 1.0F;
  float emission = 0;
  double shininess = 0.5;
  material.specular = 0.5F;
  if (id >= 0) {
    if (is_default) color = model.mat_rgba + 4 * id;
    emission = model.mat_emission[id];
    material.specular = model.mat_specular[id];
    material.reflectance = model.mat_reflectance[id];
    shininess = model.mat_shininess[id];
    material.texture = textures.find(model.mat_texid[id]);
  }
  material.rgb = three(color);
  material.alpha = color[3];
  for (int k = 0; k < 3; ++k) material.emission[k] = emission * color[k];
  material.shininess = power(128 * shininess);
  if (material.texture != nullptr) map_texture(model, id, shape, material);
  return material;
}

}  // namespace mimo::rays
