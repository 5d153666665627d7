// From what OpenGL gives to what a Picture holds, and from there to what callers want.

#include "render/pixels.h"

#include <gtest/gtest.h>

#include <vector>

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

TEST(Pixels, DepthOfParallelRaysIsEven) {
  std::vector<float> depth = {0, 0.25F, 1};
  depth_to_metres(depth.data(), depth.size(), 2, 10, true);
  EXPECT_EQ(depth, (std::vector<float>{2, 4, 10}));
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

TEST(Format, AddsAlphaAndTurnsUpsideDown) {
  std::vector<std::uint8_t> colors = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 0};
  std::vector<float> depth = {1, 2, 3, 4};
  std::vector<std::int32_t> ids = {5, 6, 7, 8};
  deliver({2, 2, colors.data(), depth.data(), ids.data()}, {true, true});
  EXPECT_EQ(colors, (std::vector<std::uint8_t>{7, 8, 9, 255, 10, 11, 12, 255, 1, 2, 3, 255, 4, 5, 6, 255}));
  EXPECT_EQ(depth, (std::vector<float>{3, 4, 1, 2}));
  EXPECT_EQ(ids, (std::vector<std::int32_t>{7, 8, 5, 6}));
}

TEST(Format, OfRenderersChangesNothing) {
  std::vector<std::uint8_t> colors = {1, 2, 3, 4, 5, 6};
  deliver({1, 2, colors.data()}, {});
  EXPECT_EQ(colors, (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
}

TEST(Format, WhatIsNotWantedStaysAway) {
  std::vector<float> depth = {1, 2};
  deliver({1, 2, nullptr, depth.data()}, {true, true});
  EXPECT_EQ(depth, (std::vector<float>{2, 1}));
}

}  // namespace
}  // namespace mimo::render
