// From what OpenGL gives to what a Picture holds.
#include "render/pixels.h"

#include <gtest/gtest.h>

namespace mimo::render {
namespace {

TEST(Pixels, FlipTurnsRowsUpsideDown) {
  std::vector<unsigned char> pixels = {1, 2, 3, 4, 5, 6};
  flip_rows(pixels.data(), 2, 3);
  EXPECT_EQ(pixels, (std::vector<unsigned char>{5, 6, 3, 4, 1, 2}));
  flip_rows(pixels.data(), 3, 2);
  EXPECT_EQ(pixels, (std::vector<unsigned char>{4, 1, 2, 5, 6, 3}));
  flip_rows(pixels.data(), 6, 1);
  EXPECT_EQ(pixels, (std::vector<unsigned char>{4, 1, 2, 5, 6, 3}));
}

TEST(Pixels, DepthRunsFromNearToFar) {
  const double near = 0.005, far = 100, z = 1.9;
  // What a perspective writes into the depth buffer at z.
  const double in_buffer = far / (far - near) * (1 - near / z);
  std::vector<float> depth = {0, static_cast<float>(in_buffer), 1};
  depth_to_metres(depth.data(), depth.size(), near, far);
  EXPECT_EQ(depth[0], 0.005F);
  EXPECT_NEAR(depth[1], 1.9, 1e-4);
  EXPECT_EQ(depth[2], 100.0F);
}

TEST(Pixels, IdsNameGeoms) {
  const std::vector<unsigned char> colours = {0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0, 0, 0, 1};
  std::vector<std::int32_t> geoms(70000, -1);
  geoms[0] = 40;
  geoms[256] = 41;
  geoms[65535] = 42;
  std::vector<std::int32_t> segmentation(5, -7);
  ids_to_geoms(colours.data(), 5, geoms, segmentation.data());
  EXPECT_EQ(segmentation, (std::vector<std::int32_t>{-1, 40, -1, 41, 42}));
}

TEST(Pixels, AnIdBeyondTheListIsBackground) {
  const std::vector<unsigned char> colours = {3, 0, 0};
  std::int32_t segmentation = -7;
  ids_to_geoms(colours.data(), 1, {10, 11}, &segmentation);
  EXPECT_EQ(segmentation, -1);
}

}  // namespace
}  // namespace mimo::render
