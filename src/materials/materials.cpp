#include "materials/materials.h"

#include <iterator>

#include "sound/mode_tables.h"

namespace mimo::materials {
namespace {

struct Texture {
  double wavelength, amplitude;
};
// Estimates.
constexpr Texture kSmooth = {1e-3, 2e-6}, kGrained = {1e-3, 10e-6}, kWoven = {1e-3, 20e-6};

// Rows of the table of timbres. Things that do not ring have none.
enum Rings { kCardboard, kCeramic, kGlass, kMetal, kPlastic, kStone, kWoodHard, kWoodSoft, kNever = -1 };

// Of a blow's energy, what ringing gives to the air: estimates, from a measured 1e-4 to 2e-4 of hard clicks.
constexpr double kClear = 3e-4, kDull = 1e-4, kFaint = 3e-5;

constexpr Material row(const char* name, double effusivity, Texture texture, double young, double poisson, Rings rings,
                       double efficiency) {
  return {
      name, effusivity, texture.wavelength, texture.amplitude, {young, poisson, efficiency, rings, texture.amplitude}};
}

// Effusivities follow from engineering tables (woods dry), those of steel, water, plastics, cloth, foam, iron, ceramic,
// cardboard, concrete and carpet from remembered handbook values, good to 20 %. Moduli of hard things are those of
// engineering tables, of soft ones estimates; skin counts as that of hands, feet and head, with bone under it.
constexpr Material kMaterials[] = {
    row("copper", 37048, kSmooth, 1.2e11, 0.34, kMetal, kClear),
    row("aluminium", 23113, kSmooth, 7e10, 0.33, kMetal, kClear),
    row("steel", 7697, kSmooth, 2e11, 0.29, kMetal, kClear),
    row("granite", 2482, kGrained, 5e10, 0.25, kStone, kFaint),
    row("glass", 1396, kSmooth, 6.2e10, 0.20, kGlass, kClear),
    row("water", 1582, {0, 0}, 1e5, 0.49, kNever, 0),
    row("polyethylene", 931, kSmooth, 1e9, 0.42, kPlastic, kDull),
    row("plastic", 514, kSmooth, 1.4e9, 0.35, kPlastic, kDull),
    row("rubber", 469, kGrained, 5e6, 0.49, kNever, 0),
    row("leather", 490, kGrained, 1e8, 0.40, kNever, 0),
    row("hardwood", 380, kGrained, 1.1e10, 0.25, kWoodHard, kDull),
    row("softwood", 291, kGrained, 8e9, 0.30, kWoodSoft, kDull),
    row("cotton", 153, kWoven, 5e4, 0.30, kNever, 0),
    row("cork", 100, kGrained, 2e7, 0.05, kNever, 0),
    row("foam", 38, kWoven, 1e5, 0.30, kNever, 0),
    row("skin", 1565, kGrained, 1e6, 0.49, kNever, 0),  // J Appl Physiol 1957;11:211
    row("iron", 16000, kGrained, 2.1e11, 0.28, kMetal, kClear),
    row("ceramic", 1500, kSmooth, 7.2e10, 0.19, kCeramic, kClear),
    row("cardboard", 230, kGrained, 5e8, 0.30, kCardboard, kFaint),
    row("concrete", 1900, kGrained, 3e10, 0.20, kStone, kFaint),
    row("carpet", 150, kWoven, 5e5, 0.30, kNever, 0),
};

}  // namespace

const Material* material(int index) {
  return index >= 0 && index < static_cast<int>(std::size(kMaterials)) ? kMaterials + index : nullptr;
}

const Material* find_material(const std::string& name) {
  for (const Material& material : kMaterials) {
    if (name == material.name) return &material;
  }
  return nullptr;
}

std::string material_names() {
  std::string names;
  for (const Material& material : kMaterials) names += (names.empty() ? "" : ", ") + std::string(material.name);
  return names;
}

}  // namespace mimo::materials
