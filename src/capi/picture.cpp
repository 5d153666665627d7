// Cameras whose pictures are observed, and pictures for people.

#include <algorithm>
#include <cmath>

#include "capi/calls.h"
#include "capi/check.h"
#include "capi/configs.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"
#include "engine/present.h"
#include "observation/foveation.h"
#include "render/pixels.h"
#include "render/renderer.h"

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
  using namespace ranges::camera_config;
  plan.options.vision =
      vision(config.outputs, "outputs", {config.width, width}, {config.height, height}, {config.fovy, fovy});
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

namespace mimo::capi {
namespace {

mimo_picture_config default_picture_config() {
  mimo_picture_config config{};
  config.struct_size = sizeof config;
  config.width = 640;
  config.height = 480;
  config.look_at[2] = 0.4;
  config.distance = 1.35;
  config.azimuth = 140;  // what lies before an infant in the built-in scenes is beside the view
  config.elevation = -12;
  return config;
}

void check_picture_config(const mimo_picture_config& config) {
  using namespace ranges::picture_config;
  check_view({config.width, width}, {config.height, height}, {config.fovy, fovy});
  in_range_or_zero(config.foveation, ranges::agent_config::vision_foveation.of("foveation"), "", "none");
  check_bits(config.format, MIMO_PICTURE_RGBA | MIMO_PICTURE_BOTTOM_UP, "format");
  if (config.camera != nullptr) return;
  check_finite(config.look_at, 3, "look_at");
  require(config.distance > 0 && std::isfinite(config.distance), "distance is {}, expected metres above 0",
          config.distance);
  require(std::isfinite(config.azimuth) && std::isfinite(config.elevation), "azimuth {}, elevation {}: not finite",
          config.azimuth, config.elevation);
}

// The id of the model's camera that a config names, -1 for the free one.
int camera_of(const env::World& world, const mimo_picture_config& config) {
  if (config.camera == nullptr) return -1;
  return engine::find_or_fail(world.model(), engine::Kind::kCamera, config.camera);
}

render::Viewpoint viewpoint(const env::World& world, const mimo_picture_config& config) {
  render::Viewpoint from;
  from.camera = camera_of(world, config);
  from.fovy = config.fovy;
  from.look_at = {config.look_at[0], config.look_at[1], config.look_at[2]};
  from.distance = config.distance;
  from.azimuth = config.azimuth;
  from.elevation = config.elevation;
  return from;
}

render::Format format_of(const mimo_picture_config& config) {
  return {(config.format & MIMO_PICTURE_RGBA) != 0, (config.format & MIMO_PICTURE_BOTTOM_UP) != 0};
}

void check_picture(const mimo_picture_config& config, const mimo_picture& to) {
  check_reserved(to.reserved, "picture: reserved");
  const std::size_t pixels = std::size_t{config.width} * config.height;
  check_buffer(to.rgb, to.rgb_bytes, static_cast<std::size_t>(format_of(config).colors()) * pixels, "picture: rgb");
  check_buffer(to.depth, to.depth_count, pixels, "picture: depth");
  check_buffer(to.segmentation, to.segmentation_count, pixels, "picture: segmentation");
}

// What eyes that look from there would see; the same for a picture of no foveation.
observation::FovealMap map_of(const mimo_picture_config& config, const render::View& from) {
  return {config.height, config.width, render::pinhole_of(from, config.width, config.height), config.foveation};
}

void foveate(const env::World& world, const mimo_picture_config& config, const render::Picture& drawn) {
  if (config.foveation == 0 || drawn.rgb == nullptr) return;
  engine::Present present;
  const render::View from = render::view_from(world.model(), present.of(world.physics()), viewpoint(world, config));
  observation::Foveation(config.height, config.width, map_of(config, from)).filter(drawn.rgb);
}

// Places in pixels are counted from the picture's corner.
void to_foveated(const observation::FovealMap& map, double* pixel) {
  const auto [x, y] = map.foveated({pixel[0] - 0.5, pixel[1] - 0.5});
  pixel[0] = x + 0.5;
  pixel[1] = y + 0.5;
}

render::Picture picture_for(const mimo_picture_config& config, const mimo_picture& to) {
  render::Picture picture;
  picture.width = static_cast<int>(config.width);
  picture.height = static_cast<int>(config.height);
  picture.rgb = to.rgb;
  picture.depth = to.depth;
  picture.segmentation = to.segmentation;
  return picture;
}

}  // namespace

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_picture_config_init(mimo_picture_config* config, size_t size) noexcept {
  return guard([&] { write_struct(config, size, default_picture_config(), "config"); });
}

mimo_status mimo_env_render(mimo_env* env, const mimo_picture_config* config, const mimo_picture* picture) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world();
    const mimo_picture_config ours = read_struct(config, default_picture_config(), "config");
    check_picture_config(ours);
    require(picture != nullptr, "picture is NULL");
    const mimo_picture to = read_struct(picture, "picture");
    check_picture(ours, to);
    const render::Picture drawn = picture_for(ours, to);
    world.draw(viewpoint(world, ours), drawn);
    foveate(world, ours, drawn);
    render::deliver(drawn, format_of(ours));
  });
}

mimo_status mimo_env_project(const mimo_env* env, const mimo_picture_config* config, const double* points, size_t count,
                             double* pixels) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world();
    const mimo_picture_config ours = read_struct(config, default_picture_config(), "config");
    check_picture_config(ours);
    check_length<double[3]>(count, "count");
    check_finite(array(points, 3 * count, "points").data(), 3 * count, "points");
    array(pixels, 3 * count, "pixels");
    engine::Present present;
    const render::View from = render::view_from(world.model(), present.of(world.physics()), viewpoint(world, ours));
    const observation::FovealMap map = map_of(ours, from);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Map<const Eigen::Vector3d> point(points + 3 * i);
      Eigen::Map<Eigen::Vector3d>(pixels + 3 * i) = render::project(from, ours.width, ours.height, point);
      if (ours.foveation > 0) to_foveated(map, pixels + 3 * i);
    }
  });
}

}  // extern "C"
