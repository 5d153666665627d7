// Blurred pictures.
#include "observation/blur.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mimo::observation {
namespace {

// A grating of the very frequency keeps half its contrast, one twice as fine a sixteenth: a Gaussian's transfer is
// itself a Gaussian, 2^-(f/f0)^2.
TEST(Blur, HalvesTheContrastAtItsFrequency) {
  constexpr double kPi = 3.14159265358979323846, kPixelsPerDegree = 8;
  constexpr std::size_t kSize = 256;
  const auto contrast = [&](double cycles, double blurred) {
    std::vector<std::uint8_t> picture(kSize * kSize * 3);
    std::vector<float> room(picture.size());
    for (std::size_t i = 0; i < picture.size(); ++i) {
      const double x = static_cast<double>(i / 3 % kSize);
      picture[i] =
          static_cast<std::uint8_t>(std::lround(128 + 120 * std::sin(2 * kPi * cycles / kPixelsPerDegree * x)));
    }
    blur(picture.data(), kSize, kSize, blur_kernel(blurred, kPixelsPerDegree), room);
    std::uint8_t least = 255, most = 0;
    for (std::size_t x = 64; x < 192; ++x) {
      least = std::min(least, picture[(100 * kSize + x) * 3]);
      most = std::max(most, picture[(100 * kSize + x) * 3]);
    }
    return (most - least) / 240.0;
  };
  EXPECT_NEAR(contrast(0.5, 0.5), 0.5, 0.01);
  EXPECT_NEAR(contrast(1, 0.5), 0.0625, 0.01);
  EXPECT_NEAR(contrast(0.25, 0.5), 0.841, 0.01);
}

TEST(Blur, LeavesEvenColoursAndBrightness) {
  std::vector<std::uint8_t> picture(20 * 30 * 3);
  for (std::size_t i = 0; i < picture.size(); ++i) picture[i] = static_cast<std::uint8_t>(40 * (i % 3) + 17);
  const auto before = picture;
  std::vector<float> room(picture.size());
  blur(picture.data(), 20, 30, blur_kernel(0.3, 4.3), room);
  EXPECT_EQ(picture, before);
}

}  // namespace
}  // namespace mimo::observation
