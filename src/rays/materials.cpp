#include "rays/materials.h"

#include <algorithm>
#include <cmath>

#include "rays/vectors.h"
#include "render/paint.h"

namespace mimo::rays {

Power power(double exponent) {
  Power p;
  p.exponent = static_cast<float>(exponent);
  const double rounded = std::round(std::min(exponent, 1e9));  // from there on, it is all the same
  const bool whole = std::abs(rounded - exponent) < 1e-4 || exponent > 8;
  p.whole = whole ? static_cast<std::int32_t>(rounded) : -1;
  return p;
}

Material material_of(const mjModel& model, int id, const float* rgba, const render::Shape& shape,
                     const Textures& textures) {
  const render::Paint paint = render::paint_of(model, id, rgba);
  Material material;
  material.rgb = three(paint.color.data());
  material.alpha = paint.color[3];
  for (int k = 0; k < 3; ++k) material.emission[k] = paint.emission * paint.color[k];
  material.specular = paint.specular;
  material.reflectance = paint.reflectance;
  material.shininess = power(128.0 * paint.shininess);
  material.texture = textures.find(paint.texture);
  if (material.texture != nullptr) {
    material.mapping = render::map_texture(model, id, material.texture->cube, shape);
    if (material.mapping.kind == Mapping::kNone) material.texture = nullptr;
  }
  return material;
}

}  // namespace mimo::rays
