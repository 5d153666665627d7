// A small world with things at known places, and pictures of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/fail.h"
#include "engine/physics.h"
#include "render/renderer.h"

namespace mimo::render::test {

// The camera "front" stands at (0, 0, 1) and looks along +x: y is left, z is up. It sees a red box, a blue one above, a
// green ball to the left, a site before a grey box to the right, a glass pane below, and a falling ball behind, to the
// left above.
inline const char* const kWorld = R"(
<mujoco>
  <statistic extent="2" center="0 0 1"/>
  <visual>
    <map znear="0.005" zfar="50"/>
    <global offwidth="8" offheight="8"/>
    <quality shadowsize="512"/>
  </visual>
  <asset>
    <texture name="sky" type="skybox" builtin="gradient" rgb1="0.5 0.7 0.9" rgb2="0.2 0.3 0.4" width="64" height="64"/>
    <texture name="tiles" type="2d" builtin="checker" rgb1="0.2 0.3 0.4" rgb2="0.1 0.2 0.3" width="64" height="64"/>
    <material name="tiles" texture="tiles" texrepeat="5 5" texuniform="true" reflectance="0.3"/>
  </asset>
  <worldbody>
    <light pos="0 0 4" dir="0.3 0 -1" castshadow="true"/>
    <camera name="front" pos="0 0 1" xyaxes="0 -1 0 0 0 1" fovy="60"/>
    <camera name="above" pos="1.5 0.5 5" xyaxes="0 -1 0 1 0 0" fovy="45"/>
    <geom name="floor" type="plane" size="0 0 0.1" material="tiles"/>
    <geom name="red" type="box" pos="2 0 1" size="0.1 0.2 0.2" rgba="1 0 0 1"/>
    <geom name="blue" type="box" pos="2 0 1.8" size="0.1 0.2 0.2" rgba="0 0 1 1"/>
    <geom name="green" type="sphere" pos="2 0.8 1" size="0.2" rgba="0 1 0 1"/>
    <geom name="grey" type="box" pos="2 -0.8 1" size="0.1 0.2 0.2" rgba="0.5 0.5 0.5 1"/>
    <site name="dot" pos="1 -0.4 1" size="0.05" rgba="1 1 0 1"/>
    <geom name="pane" type="box" pos="1 0 0.6" size="0.01 0.1 0.1" rgba="1 1 1 0.3"/>
    <body name="faller" pos="3 0.9 1.9">
      <freejoint/>
      <geom name="ball" type="sphere" size="0.1" rgba="1 0 1 1"/>
    </body>
  </worldbody>
</mujoco>)";

struct World {
  explicit World(const std::string& xml = kWorld)
      : model(engine::compile(xml, {}, LogSink{})), physics(model, engine::PhysicsOptions{}) {}

  View view(const char* camera = "front") const {
    return camera_view(*model, physics.data(), engine::find(*model, engine::Kind::kCamera, camera));
  }
  int geom(const char* name) const { return engine::find(*model, engine::Kind::kGeom, name); }

  engine::ModelPtr model;
  engine::Physics physics;
};

// A picture and its memory.
struct Image {
  Image(int w, int h) : width(w), height(h), rgb(pixels() * 3, 7), depth(pixels(), -7), segmentation(pixels(), -7) {}

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  // x from the left and y from the top, as fractions of the picture.
  std::size_t at(double x, double y) const {
    return static_cast<std::size_t>(y * height) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x * width);
  }
  Picture all() { return {width, height, rgb.data(), depth.data(), segmentation.data()}; }
  bool operator==(const Image& other) const {
    return rgb == other.rgb && depth == other.depth && segmentation == other.segmentation;
  }

  int width, height;
  std::vector<std::uint8_t> rgb;
  std::vector<float> depth;
  std::vector<std::int32_t> segmentation;
};

inline Image take(Renderer& renderer, const World& world, int width = 64, int height = 64,
                  const char* camera = "front") {
  Image image(width, height);
  renderer.draw(world.physics.model(), world.physics.data(), world.view(camera), image.all());
  return image;
}

// The status that a call fails with.
template <typename Call>
Status status_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

}  // namespace mimo::render::test
