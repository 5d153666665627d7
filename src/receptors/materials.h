// What things are made of, as skin feels it: how well they take its heat, and how rough they are.
#pragma once

#include <string>

#include "receptors/touch_afferents.h"

namespace mimo::receptors {

struct Material {
  const char* name;
  double effusivity;  // sqrt(conductivity x density x heat capacity), W s^0.5 / (m^2 K)
  Texture texture;
};

// Of living skin: J Appl Physiol 1957;11:211.
constexpr double kSkinEffusivity = 1565;

// The index-th material, or null past the last.
const Material* material(int index);
// By its name; null for one that is not known.
const Material* find_material(const std::string& name);
std::string material_names();  // with ", " between them

}  // namespace mimo::receptors
