// Fields of the observation on request.
#include "base/format.h"
#include "capi/access.h"
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

mimo_field_config default_field_config() {
  mimo_field_config config{};
  config.struct_size = sizeof config;
  config.quantity = MIMO_BODY_POSITION;
  return config;
}

std::vector<std::string> elements_of(const mimo_field_config& config) {
  std::vector<std::string> names;
  for (const char* name : array(config.elements, config.element_count, "elements")) {
    require(name != nullptr, "elements[{}] is NULL, expected a name", names.size());
    names.emplace_back(name);
  }
  return names;
}

access::FieldOptions options_from(const mimo_field_config& config) {
  access::FieldOptions options;
  const Request wanted = request_from(config.quantity);
  options.quantity = &wanted.quantity;
  options.now = wanted.now;
  options.name = text(config.name);
  require(!options.name.empty(), "name is {}, expected one for the field", config.name == nullptr ? "NULL" : "\"\"");
  require(options.name.front() != '/' && options.name.back() != '/', "name is \"{}\", expected no / at its ends",
          options.name);
  options.elements = elements_of(config);
  options.relative_to = text(config.relative_to);
  return options;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_field_config_init(mimo_field_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_field_config(), "config"); });
}

mimo_status mimo_scene_add_field(mimo_scene* scene, const mimo_field_config* config) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(config != nullptr, "config is NULL, but a field needs at least a name");
    const mimo_field_config given = read_struct(config, "config");
    const access::FieldOptions field = options_from(given);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.fields.add(field);
      note(edit, {{"call", "add_field"}, {"config", json_of(given)}, {"elements", field.elements}});
    });
  });
}

}  // extern "C"
