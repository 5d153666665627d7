// Views agree with MuJoCo's own cameras.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>

#include "render/viewpoint.h"
#include "unit/render/fixture.h"

namespace mimo::render::test {
namespace {

// What MuJoCo makes of one of its cameras: position, forward and up.
mjvGLCamera mujoco_camera(const World& world, mjvCamera camera) {
  mjvScene scene;
  mjv_defaultScene(&scene);
  mjv_updateCamera(world.model.get(), const_cast<mjData*>(&world.physics.data()), &camera, &scene);
  return mjv_averageCamera(scene.camera, scene.camera + 1);
}

void expect_same(const View& view, const mjvGLCamera& camera) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(view.position[i], camera.pos[i], 1e-6);
    EXPECT_NEAR(view.rotation(i, 1), camera.up[i], 1e-6);
    EXPECT_NEAR(-view.rotation(i, 2), camera.forward[i], 1e-6);
  }
}

// right x up = backward: nothing is mirrored.
void expect_right_handed(const View& view) {
  EXPECT_LT((view.rotation.col(0).cross(view.rotation.col(1)) - view.rotation.col(2)).norm(), 1e-9);
}

TEST(Views, CameraIsThatOfTheModel) {
  const World world;
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.type = mjCAMERA_FIXED;
  camera.fixedcamid = engine::find(*world.model, engine::Kind::kCamera, "above");
  const View view = camera_view(*world.model, world.physics.data(), camera.fixedcamid);
  expect_same(view, mujoco_camera(world, camera));
  expect_right_handed(view);
}

TEST(Views, CameraHasItsOwnFieldOfViewUnlessToldOtherwise) {
  const World world;
  const int above = engine::find(*world.model, engine::Kind::kCamera, "above");
  EXPECT_EQ(camera_view(*world.model, world.physics.data(), above).fovy, 45);
  EXPECT_EQ(camera_view(*world.model, world.physics.data(), above, 70).fovy, 70);
}

TEST(Views, OrbitIsMujocosFreeCamera) {
  const World world;
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.lookat[0] = 0.3;
  camera.lookat[1] = -0.2;
  camera.lookat[2] = 0.5;
  camera.distance = 1.7;
  camera.azimuth = 130;
  camera.elevation = -25;
  const View view = orbit_view({0.3, -0.2, 0.5}, 1.7, 130, -25, 45);
  expect_same(view, mujoco_camera(world, camera));
  expect_right_handed(view);
  EXPECT_EQ(view.fovy, 45);
}

TEST(Views, FreeCameraHasTheModelsFieldOfViewUnlessToldOtherwise) {
  const World world;
  mjModel model = *world.model;
  model.vis.global.fovy = 33;
  Viewpoint from;
  EXPECT_EQ(view_from(model, world.physics.data(), from).fovy, 33);
  from.fovy = 70;
  EXPECT_EQ(view_from(model, world.physics.data(), from).fovy, 70);
}

}  // namespace
}  // namespace mimo::render::test
