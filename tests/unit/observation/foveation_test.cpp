// Pictures with a large middle.
#include "observation/foveation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mimo::observation {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Of a picture 60 degrees high.
FovealMap map(std::size_t height, std::size_t width, double strength) {
  const double focal = static_cast<double>(height) / 2 / std::tan(kPi / 6);
  const Pinhole pinhole{focal, focal, static_cast<double>(width) / 2, static_cast<double>(height) / 2};
  return {height, width, pinhole, strength};
}

Foveation foveation(std::size_t height, std::size_t width, double strength) {
  return {height, width, map(height, width, strength)};
}

std::vector<std::uint8_t> stripes(std::size_t height, std::size_t width) {
  std::vector<std::uint8_t> rgb(height * width * 3);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = i / 3 % width % 2 == 0 ? 255 : 0;
  return rgb;
}

TEST(Foveation, KnowsWhereItsPixelsLie) {
  for (const double strength : {0.0, 0.5, 10.0}) {
    const FovealMap eye = map(90, 121, strength);
    for (double y = 0; y < 90; y += 7.25) {
      for (double x = 0; x < 121; x += 7.5) {
        const auto direction = eye.direction({x, y});
        EXPECT_NEAR(std::hypot(direction[0], direction[1], direction[2]), 1, 1e-12);
        const auto place = eye.place(direction);
        ASSERT_TRUE(place);
        EXPECT_NEAR((*place)[0], x, 1e-9);
        EXPECT_NEAR((*place)[1], y, 1e-9);
      }
    }
    EXPECT_FALSE(eye.place({0, 0, 1}));
    EXPECT_FALSE(eye.place({1, 0, 0}));
  }
}

// The corner stays where it is; right is right and up is up.
TEST(Foveation, LooksForwards) {
  const FovealMap eye = map(100, 100, 10), flat = map(100, 100, 0);
  const auto middle = eye.direction({49.5, 49.5});
  EXPECT_NEAR(middle[2], -1, 1e-12);
  EXPECT_GT(eye.direction({80, 49.5})[0], 0.01);
  EXPECT_GT(eye.direction({49.5, 20})[1], 0.01);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(eye.direction({0, 99})[i], flat.direction({0, 99})[i], 1e-12);
  // Half a picture's height beside the middle: half the angle of view.
  const auto side = flat.direction({99.5, 49.5});
  EXPECT_NEAR(std::atan2(side[0], -side[2]), kPi / 6, 1e-12);
}

TEST(Foveation, MagnifiesTheMiddle) {
  const FovealMap eye = map(101, 101, 10), flat = map(101, 101, 0);
  EXPECT_NEAR(eye.shrinkage(0), std::log(11.0) / 10, 1e-12);
  EXPECT_NEAR(eye.shrinkage(std::hypot(50, 50)), 2.638, 0.001);
  const auto near = eye.direction({50.001, 50}), before = flat.direction({50.001, 50});
  EXPECT_NEAR(near[0] / before[0], std::log(11.0) / 10, 1e-4);
}

// A white square of 11 pixels in the middle becomes one of as many as the directions say.
TEST(Foveation, DrawsThingsWhereItsMapSays) {
  const std::size_t size = 101;
  std::vector<std::uint8_t> rgb(size * size * 3);
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    const std::size_t x = i / 3 % size, y = i / 3 / size;
    rgb[i] = x >= 60 && x < 71 && y >= 40 && y < 51 ? 255 : 0;
  }
  const FovealMap eye = map(size, size, 10), flat = map(size, size, 0);
  Foveation(size, size, eye).filter(rgb.data());
  const auto edge = [&](double x, double y) { return *eye.place(flat.direction({x, y})); };
  const double left = edge(59.5, 50)[0], right = edge(70.5, 50)[0];
  for (std::size_t x = 0; x < size; ++x) {
    const double at = static_cast<double>(x);
    const int level = rgb[(50 * size + x) * 3];
    if (at < left - 3 || at > right + 3) {
      EXPECT_EQ(level, 0) << x;
    } else if (at > left + 3 && at < right - 3) {
      EXPECT_GT(level, 250) << x;
    }
  }
  // Half the light at the very edge.
  EXPECT_NEAR(rgb[(50 * size + static_cast<std::size_t>(std::lround(left))) * 3], 188, 30);
}

// Light that becomes more to the right and downwards is everywhere what it is where a pixel comes from, also in coarse
// levels.
TEST(Foveation, TakesPixelsFromWhereTheyAre) {
  const std::size_t size = 40;
  const auto light = [](double x, double y) { return 0.1 + 0.01 * (x + y); };
  std::vector<std::uint8_t> rgb(size * size * 3);
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    const double level =
        1.055 * std::pow(light(static_cast<double>(i / 3 % size), static_cast<double>(i / 3 / size)), 1 / 2.4) - 0.055;
    rgb[i] = static_cast<std::uint8_t>(std::lround(255 * level));
  }
  const FovealMap eye = map(size, size, 100), flat = map(size, size, 0);
  Foveation(size, size, eye).filter(rgb.data());
  for (std::size_t y = 0; y < size; ++y) {
    for (std::size_t x = 0; x < size; ++x) {
      const auto from = *flat.place(eye.direction({static_cast<double>(x), static_cast<double>(y)}));
      if (std::min(from[0], from[1]) < 6 || std::max(from[0], from[1]) > 33) continue;
      const double level = rgb[(y * size + x) * 3 + 1] / 255.0;
      ASSERT_NEAR(std::pow((level + 0.055) / 1.055, 2.4), light(from[0], from[1]), 0.0085) << x << " " << y;
    }
  }
}

TEST(Foveation, LeavesEvenPictures) {
  for (const double strength : {0.5, 10.0, 100.0}) {
    Foveation eye = foveation(50, 33, strength);
    for (int level = 0; level < 256; ++level) {
      std::vector<std::uint8_t> rgb(50 * 33 * 3, static_cast<std::uint8_t>(level));
      const auto before = rgb;
      eye.filter(rgb.data());
      ASSERT_EQ(rgb, before) << strength << " " << level;
    }
  }
}

TEST(Foveation, LeavesPicturesAloneWithoutStrength) {
  std::vector<std::uint8_t> rgb = stripes(20, 30);
  const auto before = rgb;
  foveation(20, 30, 0).filter(rgb.data());
  EXPECT_EQ(rgb, before);
}

// Stripes that are too fine for the shrunk rim become grey there, and not other stripes.
TEST(Foveation, MakesNoNewPatternsAtTheRim) {
  const std::size_t size = 128;
  std::vector<std::uint8_t> rgb = stripes(size, size);
  foveation(size, size, 10).filter(rgb.data());
  for (std::size_t y = 0; y < 8; ++y) {
    for (std::size_t x = 0; x < size; ++x) {
      if (x > 24 && x < 103) continue;
      EXPECT_NEAR(rgb[(y * size + x) * 3], 188, 30) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace mimo::observation
