// From how renderers draw to how callers want it.
#include "render/format.h"

#include <gtest/gtest.h>

#include <vector>

namespace mimo::render {
namespace {

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
