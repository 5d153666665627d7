#include "rays/extras.h"

#include <algorithm>

namespace mimo::rays {

bool Extras::any(const mjModel& model) {
  const auto is_spatial = [&](int first) { return model.wrap_type[first] != mjWRAP_JOINT; };
  return model.nskin > 0 || std::any_of(model.tendon_adr, model.tendon_adr + model.ntendon, is_spatial) ||
         std::count(model.actuator_trntype, model.actuator_trntype + model.nu, mjTRN_SLIDERCRANK) > 0;
}

Extras::Extras(const mjModel& model, const std::vector<SkinPattern>& patterns)
    : list_(model, {}, render::VisualScene::Shown::kExtras) {
  for (const SkinPattern& pattern : patterns) skins_.push_back({&pattern, pattern.mesh()});
}

void Extras::update(const mjModel& model, const mjData& data, const render::View& view) {
  list_.update(model, data, view);
  const mjvScene& now = list_.scene();
  for (int i = 0; i < count(); ++i) {
    if (geom(i).type != mjGEOM_SKIN) continue;
    const int id = geom(i).objid;
    const std::ptrdiff_t first = 3 * static_cast<std::ptrdiff_t>(model.skin_vertadr[id]);
    Skin& skin = skins_[static_cast<std::size_t>(id)];
    skin.place = skin.pattern->drape(now.skinvert + first, now.skinnormal + first, skin.mesh);
  }
}

const Mesh& Extras::skin(int id, double* place) const {
  const Skin& skin = skins_[static_cast<std::size_t>(id)];
  std::copy_n(skin.place.data(), 3, place);
  return skin.mesh;
}

}  // namespace mimo::rays
