// Cameras whose pictures are observed.
#include <algorithm>

#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "capi/vision.h"

namespace mimo::capi {
namespace {

mimo_camera_config default_camera_config() {
  mimo_camera_config config{};
  config.struct_size = sizeof config;
  config.outputs = MIMO_VISION_RGB;
  config.width = static_cast<std::uint32_t>(senses::VisionOptions().width);
  config.height = static_cast<std::uint32_t>(senses::VisionOptions().height);
  config.position[0] = 1.5;
  config.position[2] = 0.8;
  config.look_at[2] = 0.4;
  return config;
}

blueprint::Stand stand(const mimo_camera_config& config) {
  check_finite(config.position, 3, "position");
  check_finite(config.look_at, 3, "look_at");
  blueprint::Stand stand;
  stand.body = text(config.body);
  std::copy_n(config.position, 3, stand.position.begin());
  std::copy_n(config.look_at, 3, stand.look_at.begin());
  return stand;
}

blueprint::CameraPlan plan_from(const mimo_camera_config& config) {
  blueprint::CameraPlan plan;
  plan.options.camera = text(config.name);
  require(!plan.options.camera.empty(), "name is empty, expected the name of a camera");
  plan.options.vision =
      vision({"outputs", config.outputs}, {"width", config.width}, {"height", config.height}, {"fovy", config.fovy});
  check_flag(config.placed, "placed");
  check_reserved(config.reserved, "reserved");
  if (config.placed != 0) plan.placed = stand(config);
  return plan;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_camera_config_init(mimo_camera_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_camera_config(), "config"); });
}

mimo_status mimo_scene_add_camera(mimo_scene* scene, const mimo_camera_config* config) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(config != nullptr, "config is NULL, but a camera needs at least a name");
    mimo_camera_config given = read_struct(config, "config");
    const blueprint::CameraPlan plan = plan_from(given);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.add_camera(plan);
      given.placed = 0;  // the scene has it from now on
      note(edit, {{"call", "add_camera"}, {"config", json_of(given)}});
    });
  });
}

}  // extern "C"
