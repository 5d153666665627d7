// Scenes: where they come from, and what they become for other tools.
#include <algorithm>

#include "capi/check.h"
#include "capi/handed.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

mimo_scene_config default_scene_config() {
  mimo_scene_config config{};
  config.struct_size = sizeof config;
  return config;
}

document::Limits limits(const mimo_scene_config& config) {
  check_flag(config.confined, "config: confined");
  check_reserved(config.limits_reserved, "config: limits_reserved");
  const auto or_usual = [](std::uint64_t given, std::uint64_t usual) { return given == 0 ? usual : given; };
  const document::Limits usual;
  return {or_usual(config.max_file_bytes, usual.file_bytes),
          or_usual(config.max_pixels, usual.pixels),
          or_usual(config.max_vertices, usual.vertices),
          or_usual(config.max_elements, usual.elements),
          or_usual(config.max_keyframes, usual.keyframes),
          or_usual(config.max_iterations, usual.iterations),
          or_usual(config.max_world_bytes, usual.world_bytes),
          or_usual(config.max_compile_ms, usual.compile_ms),
          config.confined != 0};
}

scene::Source source(const mimo_scene_config& config) {
  check_reserved(config.reserved, "config: reserved");
  return {text(config.name),      text(config.file), text(config.xml),
          text(config.model_dir), limits(config),    log_sink(config.log, config.log_user)};
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_scene_config_init(mimo_scene_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_scene_config(), "config"); });
}

const char* mimo_scene_name(size_t index) noexcept { return scene::built_in_scene(index); }

mimo_status mimo_scene_create(const mimo_scene_config* config, mimo_scene** scene) noexcept {
  return guard([&] {
    mimo_scene*& result = out(scene, "scene");
    const mimo_scene_config ours = read_struct(config, default_scene_config(), "config");
    result = wrap<mimo_scene>(std::make_unique<SceneObject>(SceneObject{blueprint::Blueprint(source(ours))}));
  });
}

void mimo_scene_destroy(mimo_scene* scene) noexcept { destroy(scene); }

mimo_status mimo_scene_xml(const mimo_scene* scene, char* text, size_t capacity, size_t* length) noexcept {
  return guard(scene, [&] {
    const std::string xml = open(scene).blueprint.current().scene.xml();
    check_buffer(text, capacity, xml.size() + 1, "text");
    if (text != nullptr) std::copy_n(xml.c_str(), xml.size() + 1, text);
    if (length != nullptr) *length = xml.size();
  });
}

mimo_status mimo_scene_save(const mimo_scene* scene, const char* folder) noexcept {
  return guard(scene, [&] {
    const blueprint::Blueprint& blueprint = open(scene).blueprint;
    const std::string path = text(folder);
    require(!path.empty(), "folder is {}, expected a path", folder == nullptr ? "NULL" : "\"\"");
    document::save(blueprint.current().scene.package(), path);
  });
}

}  // extern "C"
