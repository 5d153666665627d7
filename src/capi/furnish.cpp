// Calls that furnish a scene: a room, models, and what holds bodies and joints.
#include <algorithm>

#include "capi/agents.h"
#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

mimo_model_config default_model_config() {
  mimo_model_config config{};
  config.struct_size = sizeof config;
  config.orientation[0] = 1;
  return config;
}

scene::Model model_from(const mimo_model_config& config) {
  scene::Model model;
  model.name = text(config.name);
  require(!model.name.empty(), "name is empty, expected a name for the model");
  check_plain_name(model.name);
  model.file = text(config.file);
  model.xml = text(config.xml);
  require(model.file.empty() != model.xml.empty(), "model \"{}\": {} of file and xml are set, expected one", model.name,
          model.file.empty() ? "none" : "both");
  model.pose = pose(config.position, config.orientation);
  check_flag(config.fixed, "fixed");
  model.fixed = config.fixed != 0;
  return model;
}

// Of a position and a quaternion, one after the other.
scene::Pose pose_from(const double* numbers) {
  check_finite(numbers, 7, "pose");
  double position[3], orientation[4];
  std::copy_n(numbers, 3, position);
  std::copy_n(numbers + 3, 4, orientation);
  return pose(position, orientation);
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_model_config_init(mimo_model_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_model_config(), "config"); });
}

const char* mimo_scene_room(size_t index) noexcept { return scene::built_in_room(index); }

mimo_status mimo_scene_set_room(mimo_scene* scene, const char* name) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    require(name != nullptr, "name is NULL");
    object.scene.set_room(name);
  });
}

mimo_status mimo_scene_add_model(mimo_scene* scene, const mimo_model_config* config) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    require(config != nullptr, "config is NULL, but a model needs at least a name and a document");
    object.scene.add_model(model_from(read_struct(config, default_model_config(), "config")));
  });
}

mimo_status mimo_scene_weld(mimo_scene* scene, const char* body, const char* other, const double* pose) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    require(body != nullptr, "body is NULL");
    const scene::Weld weld{body, other == nullptr ? "world" : other};
    if (pose == nullptr) return object.scene.weld(weld, nullptr);
    const scene::Pose relative = pose_from(pose);
    object.scene.weld(weld, &relative);
  });
}

mimo_status mimo_scene_lock(mimo_scene* scene, const char* joint, double value) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    require(joint != nullptr, "joint is NULL");
    object.scene.lock_joint(joint, value);
  });
}

mimo_status mimo_scene_set_pose(mimo_scene* scene, const char* joint, double value) noexcept {
  return guard(scene, [&] {
    SceneObject& object = open(scene);
    require(joint != nullptr, "joint is NULL");
    object.scene.start_joint(joint, value);
  });
}

}  // extern "C"
