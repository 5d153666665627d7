#include "env/surroundings.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/fail.h"
#include "body/body.h"
#include "engine/contacts.h"
#include "growth/maturity.h"
#include "materials/materials.h"
#include "receptors/skin.h"
#include "senses/hearing/hearing.h"
#include "senses/hearing/soundscape.h"

namespace mimo::env {
namespace {

using senses::touch::Thing;
using senses::touch::Things;

void feel_like(Thing& thing, const materials::Material& material) {
  thing.effusivity = material.effusivity;
  thing.is_flesh = std::string_view(material.name) == "skin";
  thing.wavelength = material.wavelength;
  thing.amplitude = material.amplitude;
}

void feel_as_told(Thing& thing, const ThingOptions& told) {
  if (told.temperature) thing.temperature = *told.temperature;
  if (!told.material.empty()) feel_like(thing, *materials::find_material(told.material));
}

// Calls change(geom) for a body and all that hangs on it.
template <typename Change>
void for_geoms(const mjModel& model, int root, Change&& change) {
  for (const int body : body::subtree(model, root)) {
    for (int i = 0; i < model.body_geomnum[body]; ++i) change(model.body_geomadr[body] + i);
  }
}

// Calls infant(geom) for the skin of infants, then told(geom, thing) for things that users described.
template <typename Infant, typename Told>
void for_things(const mjModel& model, const std::vector<AgentOptions>& agents, const EnvOptions& options,
                Infant&& infant, Told&& told) {
  for (const AgentOptions& agent : agents) {
    if (agent.root.empty()) for_geoms(model, body::find_body(model, agent.prefix()).root, infant);
  }
  for (const ThingOptions& thing : options.things) {
    const int body = engine::find_or_fail(model, engine::Kind::kBody, thing.body);
    for_geoms(model, body, [&](int geom) { told(geom, thing); });
  }
}

constexpr const char *kUsual = "plastic", *kSkin = "skin";

}  // namespace

void check_material(const std::string& name) {
  if (materials::find_material(name) != nullptr) return;
  fail(Status::kNotFound, "no material \"{}\"; there are: {}", name, materials::material_names());
}

const char* material_name(std::size_t index) {
  const materials::Material* material = index < 1000 ? materials::material(static_cast<int>(index)) : nullptr;
  return material == nullptr ? nullptr : material->name;
}

senses::touch::ThingsPtr things_of(const mjModel& model, const std::vector<AgentOptions>& agents,
                                   const EnvOptions& options) {
  auto things = std::make_shared<Things>();
  things->air = options.room_temperature;
  Thing usual;
  usual.temperature = options.room_temperature;
  feel_like(usual, *materials::find_material(kUsual));
  things->all.assign(static_cast<std::size_t>(model.ngeom + engine::flex_count(model)), usual);
  const double skin = receptors::resting_temperature({37, options.room_temperature});
  const auto thing_of = [&](int geom) -> Thing& { return things->all[static_cast<std::size_t>(geom)]; };
  for_things(
      model, agents, options,
      [&](int geom) {
        thing_of(geom).temperature = skin;
        feel_like(thing_of(geom), *materials::find_material(kSkin));
      },
      [&](int geom, const ThingOptions& told) { feel_as_told(thing_of(geom), told); });
  for (const ThingOptions& told : options.things) {
    const int body = engine::find_or_fail(model, engine::Kind::kBody, told.body);
    const std::vector<int> flexes = engine::flexes_on(model, body::subtree(model, body));
    for (const int flex : flexes) feel_as_told(thing_of(model.ngeom + flex), told);
  }
  return things;
}

std::shared_ptr<const std::vector<sound::Solid>> solids_of(const mjModel& model,
                                                           const std::vector<AgentOptions>& agents,
                                                           const EnvOptions& options) {
  auto solids = std::make_shared<std::vector<sound::Solid>>(static_cast<std::size_t>(model.ngeom),
                                                            materials::find_material(kUsual)->solid);
  const auto solid_of = [&](int geom) -> sound::Solid& { return (*solids)[static_cast<std::size_t>(geom)]; };
  for_things(
      model, agents, options, [&](int geom) { solid_of(geom) = materials::find_material(kSkin)->solid; },
      [&](int geom, const ThingOptions& told) {
        if (!told.material.empty()) solid_of(geom) = materials::find_material(told.material)->solid;
      });
  return solids;
}

bool listens(const std::vector<AgentOptions>& agents) {
  return std::any_of(agents.begin(), agents.end(), [](const AgentOptions& agent) { return agent.hearing.wanted != 0; });
}

senses::Soundscape* add_soundscape(observation::Observer& observer, const mjModel& model, double tick,
                                   const std::vector<AgentOptions>& agents, const EnvOptions& options) {
  if (!listens(agents)) return nullptr;
  const auto voices =
      std::count_if(agents.begin(), agents.end(), [](const AgentOptions& agent) { return agent.voice; });
  auto made = std::make_unique<senses::Soundscape>(model, solids_of(model, agents, options), tick, options.play,
                                                   static_cast<std::size_t>(voices));
  senses::Soundscape* soundscape = made.get();
  observer.add(std::make_unique<senses::Around>(std::move(made)));
  return soundscape;
}

void add_voice(Perception& agent, const mjModel& model, const AgentOptions& options, senses::Soundscape* soundscape) {
  agent.voice = std::make_shared<sound::Utterance>();
  const auto add = [&](const char* name, double low, double high, const char* unit, double& number) {
    agent.actuation->add_control(options.prefix() + name, low, high, unit,
                                 std::shared_ptr<double>(agent.voice, &number));
  };
  add("voice:loudness", 0, 1, "", agent.voice->loudness);
  add("voice:pitch", -0.5, 0.5, "octave", agent.voice->pitch);
  add("voice:opening", 0.7, 1.3, "", agent.voice->opening);
  add("voice:front", 0.7, 1.3, "", agent.voice->front);
  senses::Mouth mouth = senses::mouth_of(model, agent.body);
  if (soundscape == nullptr) return;
  const double age = (options.growth.body ? options.growth : growth::Growth{}).age;  // of the size of its throat
  mouth.pitch = growth::vocal_pitch(age);
  mouth.formants = growth::vocal_formants(age);
  mouth.told = agent.voice;
  agent.own_sound = soundscape->add(mouth);
}

void play(senses::Soundscape* soundscape, const mjModel& model, const std::string& body, Span<const float> samples,
          double rate) {
  if (soundscape == nullptr) fail(Status::kUnsupported, "no agent has hearing: switch it on for one");
  const int id = engine::find_or_fail(model, engine::Kind::kBody, body);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    require(std::isfinite(samples[i]), "samples[{}] is {}, expected a finite number", i, samples[i]);
    require(std::abs(samples[i]) <= 1e6F, "samples[{}] is {}, expected up to 1e6 Pa", i, samples[i]);
  }
  soundscape->play(id, samples, rate);
}

}  // namespace mimo::env
