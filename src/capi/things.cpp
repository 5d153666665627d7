// How things of a scene feel to skin.
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/use.h"
#include "env/surroundings.h"

namespace mimo::capi {
namespace {

constexpr double kAbsoluteZero = -273.15;

std::string body_name(const char* body) {
  const std::string name = text(body);
  require(!name.empty(), "body is {}, expected a name", body == nullptr ? "NULL" : "\"\"");
  return name;
}

void add(mimo_scene* scene, const env::ThingOptions& thing, const Json& call) {
  open(scene).blueprint.edit([&](blueprint::SceneEdit& edit) {
    edit.things.push_back(thing);
    note(edit, call);
  });
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_scene_set_room_temperature(mimo_scene* scene, double celsius) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(celsius >= -40 && celsius <= 80, "celsius is {}, expected -40 to 80 in a room", celsius);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.room_temperature = celsius;
      note(edit, {{"call", "set_room_temperature"}, {"celsius", celsius}});
    });
  });
}

mimo_status mimo_scene_set_temperature(mimo_scene* scene, const char* body, double celsius) noexcept {
  return guard(scene, [&] {
    open(scene);
    const std::string name = body_name(body);
    require(celsius >= kAbsoluteZero && celsius <= 1000, "celsius of body \"{}\" is {}, expected -273.15 to 1000", name,
            celsius);
    add(scene, {name, celsius, ""}, {{"call", "set_temperature"}, {"body", name}, {"celsius", celsius}});
  });
}

mimo_status mimo_scene_set_material(mimo_scene* scene, const char* body, const char* material) noexcept {
  return guard(scene, [&] {
    open(scene);
    const std::string name = body_name(body), of = text(material);
    require(!of.empty(), "material of body \"{}\" is {}, expected a name", name, material == nullptr ? "NULL" : "\"\"");
    env::check_material(of);
    add(scene, {name, std::nullopt, of}, {{"call", "set_material"}, {"body", name}, {"material", of}});
  });
}

const char* mimo_material_name(size_t index) noexcept { return env::material_name(index); }

}  // extern "C"
