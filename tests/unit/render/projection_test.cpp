// Where points appear in a picture.
#include "render/projection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/render/fixture.h"

namespace mimo::render::test {
namespace {

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
