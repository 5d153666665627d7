#include <algorithm>

#include "capi/agents.h"
#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

mimo_scene_config default_scene_config() {
  mimo_scene_config config{};
  config.struct_size = sizeof config;
  return config;
}

mimo_object_config default_object_config() {
  mimo_object_config config{};
  config.struct_size = sizeof config;
  config.shape = MIMO_SHAPE_SPHERE;
  config.size[0] = 0.04;
  config.orientation[0] = 1;
  config.mass = 0.1;
  config.rgba[0] = 0.9;
  config.rgba[1] = 0.2;
  config.rgba[2] = 0.2;
  config.rgba[3] = 1;
  return config;
}

scene::Limits limits(const mimo_scene_config& config) {
  check_flag(config.confined, "config: confined");
  check_reserved(config.limits_reserved, "config: limits_reserved");
  const auto or_usual = [](std::uint64_t given, std::uint64_t usual) { return given == 0 ? usual : given; };
  const scene::Limits usual;
  return {or_usual(config.max_file_bytes, usual.file_bytes),   or_usual(config.max_pixels, usual.pixels),
          or_usual(config.max_vertices, usual.vertices),       or_usual(config.max_elements, usual.elements),
          or_usual(config.max_keyframes, usual.keyframes),     or_usual(config.max_iterations, usual.iterations),
          or_usual(config.max_world_bytes, usual.world_bytes), config.confined != 0};
}

scene::Source source(const mimo_scene_config& config) {
  check_reserved(config.reserved, "config: reserved");
  scene::Source source{text(config.name),      text(config.file), text(config.xml),
                       text(config.model_dir), limits(config),    LogSink{config.log, config.log_user}};
  const int given = !source.name.empty() + !source.file.empty() + !source.xml.empty();
  require(given <= 1, "config: name \"{}\", file \"{}\" and xml exclude each other, {} of them are set", source.name,
          source.file, given);
  return source;
}

// How many of the three sizes each shape has.
int size_count(std::int32_t shape) {
  switch (shape) {
    case MIMO_SHAPE_SPHERE: return 1;
    case MIMO_SHAPE_CAPSULE:
    case MIMO_SHAPE_CYLINDER: return 2;
    case MIMO_SHAPE_ELLIPSOID:
    case MIMO_SHAPE_BOX: return 3;
    default: fail(Status::kInvalidArgument, "shape is {}, expected MIMO_SHAPE_SPHERE (1) to MIMO_SHAPE_BOX (5)", shape);
  }
}

scene::Object object_from(const mimo_object_config& config) {
  scene::Object object;
  object.name = text(config.name);
  require(!object.name.empty(), "name is empty, expected a name for the object");
  const int sizes = size_count(config.shape);
  object.shape = static_cast<scene::Shape>(config.shape);
  for (int i = 0; i < sizes; ++i) {
    require(config.size[i] > 0 && std::isfinite(config.size[i]), "size[{}] is {}, expected metres above 0", i,
            config.size[i]);
    object.size[static_cast<std::size_t>(i)] = config.size[i];
  }
  object.pose = pose(config.position, config.orientation);
  require(config.mass >= 0 && std::isfinite(config.mass), "mass is {}, expected kilograms, or 0", config.mass);
  object.mass = config.mass;
  for (int i = 0; i < 4; ++i) {
    require(config.rgba[i] >= 0 && config.rgba[i] <= 1, "rgba[{}] is {}, expected 0 to 1", i, config.rgba[i]);
    object.rgba[static_cast<std::size_t>(i)] = config.rgba[i];
  }
  check_flag(config.fixed, "fixed");
  check_reserved(config.reserved, "reserved");
  object.fixed = config.fixed != 0;
  return object;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_scene_config_init(mimo_scene_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_scene_config(), "config"); });
}

mimo_status mimo_agent_config_init(mimo_agent_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_agent_config(), "config"); });
}

mimo_status mimo_object_config_init(mimo_object_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_object_config(), "config"); });
}

const char* mimo_scene_builtin(size_t index) noexcept { return scene::built_in_scene(index); }

mimo_status mimo_scene_create(const mimo_scene_config* config, mimo_scene** scene) noexcept {
  return guard([&] {
    mimo_scene*& result = out(scene, "scene");
    const mimo_scene_config ours = read_struct(config, default_scene_config(), "config");
    result = wrap<mimo_scene>(std::make_unique<SceneObject>(
        SceneObject{scene::Scene(source(ours)), {}, LogSink{ours.log, ours.log_user}, {}}));
  });
}

void mimo_scene_destroy(mimo_scene* scene) noexcept { destroy(scene); }

mimo_status mimo_scene_add_agent(mimo_scene* scene, const mimo_agent_config* config, int32_t* agent) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    const mimo_agent_config defaults = default_agent_config(object.scene);
    const std::size_t index = add_agent(object, read_struct(config, defaults, "config"));
    if (agent != nullptr) *agent = static_cast<int32_t>(index);
  });
}

mimo_status mimo_scene_default_agent(const mimo_scene* scene, mimo_agent_config* config, size_t size) noexcept {
  return guard(scene, [&] { write_struct(config, size, default_agent_config(open(scene).scene), "config"); });
}

mimo_status mimo_scene_read_joint(mimo_scene* scene, int32_t agent, const char* joint) noexcept {
  return guard(scene, [&] {
    env::AgentOptions& options = agent_at(open(scene), agent);
    const std::string name = text(joint);
    require(!name.empty(), "joint is {}, expected a name", joint == nullptr ? "NULL" : "\"\"");
    const bool there = std::find(options.joints.begin(), options.joints.end(), name) != options.joints.end();
    require(!there, "joint \"{}\" is read already", name);
    options.joints.push_back(name);
  });
}

mimo_status mimo_scene_add_object(mimo_scene* scene, const mimo_object_config* config) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    require(config != nullptr, "config is NULL, but an object needs at least a name");
    object.scene.add_object(object_from(read_struct(config, default_object_config(), "config")));
  });
}

mimo_status mimo_scene_add_agents(mimo_scene* scene, const mimo_agent_config* config, size_t* count) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    const mimo_agent_config defaults = default_agent_config(object.scene);
    const std::size_t added = add_agents(object, read_struct(config, defaults, "config"));
    if (count != nullptr) *count = added;
  });
}

mimo_status mimo_scene_xml(const mimo_scene* scene, char* text, size_t capacity, size_t* length) noexcept {
  return guard(scene, [&] {
    const std::string xml = open(scene).scene.xml();
    check_buffer(text, capacity, xml.size() + 1, "text");
    if (text != nullptr) std::copy_n(xml.c_str(), xml.size() + 1, text);
    if (length != nullptr) *length = xml.size();
  });
}

mimo_status mimo_scene_save(const mimo_scene* scene, const char* folder) noexcept {
  return guard([&] {
    const SceneObject& object = open(scene);
    const std::string path = text(folder);
    require(!path.empty(), "folder is {}, expected a path", folder == nullptr ? "NULL" : "\"\"");
    object.scene.save(path);
  });
}

}  // extern "C"
