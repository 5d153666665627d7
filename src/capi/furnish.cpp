// Calls that furnish a scene: a room, objects, models, and what holds bodies and joints.
#include <algorithm>
#include <optional>

#include "base/format.h"
#include "capi/check.h"
#include "capi/configs.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

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

mimo_model_config default_model_config() {
  mimo_model_config config{};
  config.struct_size = sizeof config;
  config.orientation[0] = 1;
  return config;
}

scene::ObjectShape shape_from(std::int32_t shape) {
  check_choice(shape, MIMO_SHAPE_SPHERE, MIMO_SHAPE_BOX, "shape");
  return static_cast<scene::ObjectShape>(shape);
}

const char* sizes_of(scene::ObjectShape shape) {
  switch (shape) {
    case scene::ObjectShape::kSphere: return "of a sphere its radius";
    case scene::ObjectShape::kCapsule: return "for a capsule its radius and half the length of its cylinder";
    case scene::ObjectShape::kCylinder: return "for a cylinder its radius and half its length";
    case scene::ObjectShape::kEllipsoid: return "for an ellipsoid its three radii";
    case scene::ObjectShape::kBox: return "for a box half of each of its three edges";
  }
  return "";
}

scene::Object object_from(const mimo_object_config& config) {
  scene::Object object;
  object.name = text(config.name);
  require(!object.name.empty(), "name is empty, expected a name for the object");
  object.shape = shape_from(config.shape);
  for (std::size_t i = 0; i < scene::size_count(object.shape); ++i) {
    require(config.size[i] > 0 && std::isfinite(config.size[i]), "size[{}] is {}, expected metres above 0, {}", i,
            config.size[i], sizes_of(object.shape));
    object.size[i] = config.size[i];
  }
  object.pose = pose(config.position, config.orientation);
  require(config.mass >= 0 && std::isfinite(config.mass), "mass is {}, expected kilograms, or 0", config.mass);
  object.mass = config.mass;
  for (int i = 0; i < 4; ++i) {
    require_between(config.rgba[i], 0.0, 1.0, format("rgba[{}]", i).c_str());
    object.rgba[static_cast<std::size_t>(i)] = config.rgba[i];
  }
  check_flag(config.fixed, "fixed");
  check_reserved(config.reserved, "reserved");
  object.fixed = config.fixed != 0;
  return object;
}

scene::Model model_from(const mimo_model_config& config) {
  scene::Model model;
  model.name = text(config.name);
  require(!model.name.empty(), "name is empty, expected a name for the model");
  model.file = text(config.file);
  model.xml = text(config.xml);
  model.pose = pose(config.position, config.orientation);
  check_flag(config.fixed, "fixed");
  model.fixed = config.fixed != 0;
  return model;
}

// Of a position and a quaternion, one after the other.
document::Pose pose_from(const double* numbers) {
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

mimo_status mimo_object_config_init(mimo_object_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_object_config(), "config"); });
}

mimo_status mimo_model_config_init(mimo_model_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_model_config(), "config"); });
}

const char* mimo_room_name(size_t index) noexcept { return scene::built_in_room(index); }

mimo_status mimo_scene_set_room(mimo_scene* scene, const char* name) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(name != nullptr, "name is NULL");
    blueprint.edit([&](blueprint::SceneEdit& edit) { edit.scene.set_room(name); });
  });
}

mimo_status mimo_scene_add_object(mimo_scene* scene, const mimo_object_config* config) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(config != nullptr, "config is NULL, but an object needs at least a name");
    const scene::Object object = object_from(read_struct(config, "config"));
    blueprint.edit([&](blueprint::SceneEdit& edit) { edit.scene.add_object(object); });
  });
}

mimo_status mimo_scene_add_model(mimo_scene* scene, const mimo_model_config* config) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(config != nullptr, "config is NULL, but a model needs at least a name and a document");
    const scene::Model model = model_from(read_struct(config, "config"));
    blueprint.edit([&](blueprint::SceneEdit& edit) { edit.scene.add_model(model); });
  });
}

mimo_status mimo_scene_weld(mimo_scene* scene, const char* body, const char* other, const double* pose) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(body != nullptr, "body is NULL");
    scene::Weld weld;
    weld.body = body;
    if (other != nullptr) weld.other = other;
    std::optional<document::Pose> relative;
    if (pose != nullptr) relative = pose_from(pose);
    blueprint.edit([&](blueprint::SceneEdit& edit) { edit.scene.weld(weld, relative ? &*relative : nullptr); });
  });
}

mimo_status mimo_scene_lock(mimo_scene* scene, const char* joint, double value) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(joint != nullptr, "joint is NULL");
    blueprint.edit([&](blueprint::SceneEdit& edit) { edit.scene.lock_joint(joint, value); });
  });
}

mimo_status mimo_scene_set_pose(mimo_scene* scene, const char* joint, double value) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(joint != nullptr, "joint is NULL");
    blueprint.edit([&](blueprint::SceneEdit& edit) { edit.scene.start_joint(joint, value); });
  });
}

}  // extern "C"
