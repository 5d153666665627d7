#include "env/things.h"

#include <string_view>

#include "base/fail.h"
#include "body/body.h"
#include "receptors/materials.h"
#include "receptors/skin_temperature.h"

namespace mimo::env {
namespace {

using senses::touch::Thing;
using senses::touch::Things;

void feel_like(Thing& thing, const receptors::Material& material) {
  thing.effusivity = material.effusivity;
  thing.is_flesh = std::string_view(material.name) == "skin";
  thing.wavelength = material.texture.wavelength;
  thing.amplitude = material.texture.amplitude;
}

template <typename Change>
void change_all(const mjModel& model, int root, Things& things, Change&& change) {
  for (const int body : body::subtree(model, root)) {
    for (int i = 0; i < model.body_geomnum[body]; ++i) {
      change(things.by_geom[static_cast<std::size_t>(model.body_geomadr[body] + i)]);
    }
  }
}

}  // namespace

void check_material(const std::string& name) {
  if (receptors::find_material(name) != nullptr) return;
  fail(Status::kNotFound, "no material \"{}\"; there are: {}", name, receptors::material_names());
}

const char* material_name(std::size_t index) {
  const receptors::Material* material = index < 1000 ? receptors::material(static_cast<int>(index)) : nullptr;
  return material == nullptr ? nullptr : material->name;
}

senses::touch::ThingsPtr things_of(const mjModel& model, const std::vector<AgentOptions>& agents,
                                   const EnvOptions& options) {
  auto things = std::make_shared<Things>();
  things->air = options.room_temperature;
  Thing usual;
  usual.temperature = options.room_temperature;
  feel_like(usual, *receptors::find_material("plastic"));
  things->by_geom.assign(static_cast<std::size_t>(model.ngeom), usual);
  const double skin = receptors::resting_temperature({37, options.room_temperature});
  for (const AgentOptions& agent : agents) {
    if (!agent.root.empty()) continue;
    change_all(model, body::find_body(model, agent.prefix()).root, *things, [&](Thing& thing) {
      thing.temperature = skin;
      feel_like(thing, *receptors::find_material("skin"));
    });
  }
  for (const ThingOptions& told : options.things) {
    const int body = engine::find_or_fail(model, engine::Kind::kBody, told.body);
    change_all(model, body, *things, [&](Thing& thing) {
      if (told.temperature) thing.temperature = *told.temperature;
      if (!told.material.empty()) feel_like(thing, *receptors::find_material(told.material));
    });
  }
  return things;
}

}  // namespace mimo::env
