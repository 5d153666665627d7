// What things are made of: how well they take skin's heat, how rough they are, how they sound.
#pragma once

#include <string>

#include "sound/impact.h"

namespace mimo::materials {

struct Material {
  const char* name;
  double effusivity;             // sqrt(conductivity x density x heat capacity), W s^0.5 / (m^2 K)
  double wavelength, amplitude;  // of its texture, m
  sound::Solid solid;
};

// The index-th material, or null past the last.
const Material* material(int index);
// By its name; null for one that is not known.
const Material* find_material(const std::string& name);
std::string material_names();  // with ", " between them

}  // namespace mimo::materials
