#include "receptors/materials.h"

#include <iterator>

namespace mimo::receptors {
namespace {

// Effusivities follow from engineering tables (woods dry), those of steel, water, plastics, cloth and foam from
// remembered handbook values, good to 20 %. Textures are estimates.
constexpr Texture kSmooth = {1e-3, 2e-6}, kGrained = {1e-3, 10e-6}, kWoven = {1e-3, 20e-6};
constexpr Material kMaterials[] = {{"copper", 37048, kSmooth},     {"aluminium", 23113, kSmooth},
                                   {"steel", 7697, kSmooth},       {"granite", 2482, kGrained},
                                   {"glass", 1396, kSmooth},       {"water", 1582, {0, 0}},
                                   {"polyethylene", 931, kSmooth}, {"plastic", 514, kSmooth},
                                   {"rubber", 469, kGrained},      {"leather", 490, kGrained},
                                   {"hardwood", 380, kGrained},    {"softwood", 291, kGrained},
                                   {"cotton", 153, kWoven},        {"cork", 100, kGrained},
                                   {"foam", 38, kWoven},           {"skin", kSkinEffusivity, kGrained}};

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

}  // namespace mimo::receptors
