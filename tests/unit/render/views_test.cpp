// Views agree with MuJoCo's own cameras; where points appear in a picture.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "compat/mujoco.h"
#include "render/renderer.h"
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

#if MIMO_MUJOCO_4

// A camera above the origin.
World filmed(const std::string& camera) {
  return World("<mujoco><worldbody><geom size='.1'/><camera pos='0 0 3' " + camera + "/></worldbody></mujoco>");
}

mjvGLCamera mujoco_camera(const World& world) {
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.type = mjCAMERA_FIXED;
  camera.fixedcamid = 0;
  return mujoco_camera(world, camera);
}

// 20 x 10 mm behind 20 and 10 mm of focal length: slopes are 10 / 20 and 5 / 10, moved by 2 / 20 and -1 / 10.
TEST(Views, ASensorIsThatOfMujoco) {
  const World world = filmed("resolution='128 64' sensorsize='.02 .01' focal='.02 .01' principal='.002 .001'");
  const mjvGLCamera theirs = mujoco_camera(world);
  const View::Edges edges = camera_view(*world.model, world.physics.data(), 0).edges;
  const double near = theirs.frustum_near;
  EXPECT_NEAR(edges.left, 0.1 - 0.5, 1e-6);
  EXPECT_NEAR(edges.right, 0.1 + 0.5, 1e-6);
  EXPECT_NEAR(edges.bottom, -0.1 - 0.5, 1e-6);
  EXPECT_NEAR(edges.top, -0.1 + 0.5, 1e-6);
  EXPECT_NEAR(edges.left, (theirs.frustum_center - theirs.frustum_width) / near, 1e-6);
  EXPECT_NEAR(edges.right, (theirs.frustum_center + theirs.frustum_width) / near, 1e-6);
  EXPECT_NEAR(edges.bottom, theirs.frustum_bottom / near, 1e-6);
  EXPECT_NEAR(edges.top, theirs.frustum_top / near, 1e-6);
  // The origin is on its axis: 40 % of the width and of the height from the upper left corner.
  const Eigen::Vector3d middle = project(camera_view(*world.model, world.physics.data(), 0), 200, 100, {0, 0, 0});
  EXPECT_LT((middle - Eigen::Vector3d(80, 40, 3)).norm(), 1e-4);
}

TEST(Views, AFieldOfViewTakesTheSensorsPlace) {
  const World world = filmed("resolution='128 64' sensorsize='.02 .01' focal='.02 .01' principal='.002 .001'");
  const View view = camera_view(*world.model, world.physics.data(), 0, 70);
  EXPECT_FALSE(view.edges.given());
  EXPECT_EQ(view.fovy, 70);
}

TEST(Views, AnOrthographicCameraIsThatOfMujoco) {
  const World world = filmed("projection='orthographic' fovy='4'");
  const View view = camera_view(*world.model, world.physics.data(), 0);
  const mjvGLCamera theirs = mujoco_camera(world);
  EXPECT_EQ(theirs.orthographic, 1);
  EXPECT_TRUE(view.parallel);
  EXPECT_NEAR(view.half_height(), theirs.frustum_top, 1e-6);
  // 4 m are 100 pixels, wherever a point is.
  EXPECT_LT((project(view, 200, 100, {1, 0.5, 0}) - Eigen::Vector3d(125, 37.5, 3)).norm(), 1e-9);
  EXPECT_LT((project(view, 200, 100, {1, 0.5, -7}) - Eigen::Vector3d(125, 37.5, 10)).norm(), 1e-9);
}

#endif

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

// Looks along -z with y up. 90 degrees across 100 rows: at a depth of 1 m, a metre is 50 pixels.
View plain() {
  View view;
  view.rotation.setIdentity();
  view.fovy = 90;
  return view;
}

TEST(Projection, PixelsRightAndDownAndDepth) {
  const Eigen::Vector3d pixel = project(plain(), 200, 100, {1, 2, -4});
  EXPECT_NEAR(pixel[0], 100 + 50 * 1.0 / 4, 1e-12);
  EXPECT_NEAR(pixel[1], 50 - 50 * 2.0 / 4, 1e-12);
  EXPECT_EQ(pixel[2], 4);
}

TEST(Projection, BehindTheCameraDepthIsNegative) { EXPECT_EQ(project(plain(), 200, 100, {0, 0, 3})[2], -3); }

TEST(Projection, FollowsTheCamera) {
  const World world;
  // The red box's middle is 2 m before the camera, the green ball's 0.8 m left of that, the blue box's 0.8 m above.
  const double focal = 32 / std::tan(30 * 3.14159265358979323846 / 180);
  const Eigen::Vector3d red = project(world.view(), 64, 64, {2, 0, 1});
  EXPECT_LT((red - Eigen::Vector3d(32, 32, 2)).norm(), 1e-12);
  const Eigen::Vector3d green = project(world.view(), 64, 64, {2, 0.8, 1});
  EXPECT_LT((green - Eigen::Vector3d(32 - focal * 0.4, 32, 2)).norm(), 1e-12);
  const Eigen::Vector3d blue = project(world.view(), 64, 64, {2, 0, 1.8});
  EXPECT_LT((blue - Eigen::Vector3d(32, 32 - focal * 0.4, 2)).norm(), 1e-12);
}

}  // namespace
}  // namespace mimo::render::test
