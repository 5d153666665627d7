// What lesser eyes leave of pictures.
#include "observation/eyesight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "observation/gaussian.h"

namespace mimo::observation {
namespace {

constexpr double kPi = 3.14159265358979323846;
using Picture = std::vector<std::uint8_t>;

// sRGB, IEC 61966-2-1.
double light_of(double level) {
  const double code = level / 255;
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

std::uint8_t level_of(double light) {
  const double code = light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * code));
}

// The contrast that is left in the middle of a picture of upright lines, `cycles` of them in a pixel.
double contrast_left(std::size_t size, double cycles, double sigma) {
  constexpr double kMean = 0.4, kContrast = 0.9;
  const auto wave = [&](std::size_t x) { return std::sin(2 * kPi * cycles * static_cast<double>(x) + 0.3); };
  Picture picture(size * size * 3);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    picture[i] = level_of(kMean * (1 + kContrast * wave(i / 3 % size)));
  }
  EyeFilter(size, size, sigma, 1).filter(picture.data());
  double both = 0, square = 0;
  for (std::size_t x = size / 4; x < size * 3 / 4; ++x) {
    both += wave(x) * (light_of(picture[(size / 2 * size + x) * 3]) - kMean);
    square += wave(x) * wave(x);
  }
  return both / square / (kMean * kContrast);
}

// What is left of gratings of .1, .25, .5, 1 and 2 cycles per degree at an age, from the formula, by hand.
struct Row {
  Eyesight eyes;
  double left[5];
};
const Row kRows[] = {{{0.70, 2, 1}, {0.9860, 0.9154, 0.7021, 0.2430, 0.0035}},
                     {{0.88, 2.8, 1}, {0.9868, 0.9203, 0.7172, 0.2646, 0.0049}},
                     {{2.16, 6.3246, 1}, {0.9961, 0.9756, 0.9059, 0.6735, 0.2057}},
                     {{6.01, 14, 1}, {0.9993, 0.9954, 0.9819, 0.9295, 0.7466}},
                     {{7.47, 20, 1}, {0.9995, 0.9967, 0.9867, 0.9477, 0.8067}},
                     {{11.1, 40, 1}, {0.9997, 0.9981, 0.9925, 0.9705, 0.8871}}};
constexpr double kCycles[] = {0.1, 0.25, 0.5, 1, 2};

// Pictures of 60 degrees with 64 to 512 rows, wherever they can hold the lines.
TEST(Eyesight, LeavesTheContrastOfItsAge) {
  for (const std::size_t size : {64, 128, 256, 512}) {
    const double pixels_per_degree = static_cast<double>(size) / 2 / std::tan(kPi / 6) * kPi / 180;
    for (const Row& row : kRows) {
      for (std::size_t i = 0; i < 5; ++i) {
        const double cycles = kCycles[i] / pixels_per_degree;
        if (cycles > 0.4) continue;  // lines that a picture cannot hold
        EXPECT_NEAR(contrast_left(size, cycles, row.eyes.sigma() * pixels_per_degree), row.left[i], 0.02)
            << size << " pixels, acuity " << row.eyes.acuity << ", " << kCycles[i] << " cycles per degree";
      }
    }
  }
}

TEST(Eyesight, GaussiansAreRightBelowAPixelToo) {
  for (const double sigma : {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0, 2.0, 5.0}) {
    const std::vector<float> kernel = gaussian(sigma);
    for (double f = 0; f < 0.5; f += 0.01) {
      double left = static_cast<double>(kernel[0]);
      for (std::size_t k = 1; k < kernel.size(); ++k) {
        left += 2 * static_cast<double>(kernel[k]) * std::cos(2 * kPi * static_cast<double>(k) * f);
      }
      const double most = f > 0.4 ? 0.06 : 0.02;  // all but the finest lines
      EXPECT_NEAR(left, std::exp(-2 * kPi * kPi * sigma * sigma * f * f), most) << sigma << " pixels, " << f;
    }
  }
}

// Lines of black and white that are too fine to be seen are grey, as bright as both together: 187.5 of 255.
TEST(Eyesight, MixesLightAndNotBytes) {
  Picture picture(64 * 64 * 3);
  for (std::size_t i = 0; i < picture.size(); ++i) picture[i] = i / 3 % 2 == 0 ? 0 : 255;
  EyeFilter(64, 64, 3, 1).filter(picture.data());
  EXPECT_NEAR(picture[(32 * 64 + 32) * 3], 187.5, 1);
}

TEST(Eyesight, LeavesEvenColours) {
  for (int level = 0; level < 256; ++level) {
    Picture picture(20 * 30 * 3);
    for (std::size_t i = 0; i < picture.size(); ++i)
      picture[i] = static_cast<std::uint8_t>((level + 60 * (i % 3)) % 256);
    const Picture before = picture;
    EyeFilter(20, 30, 1.3, 1).filter(picture.data());
    EXPECT_EQ(picture, before);
  }
}

// Luminance stays; half of what a channel differs from it is left, in light.
TEST(Eyesight, TakesColourAway) {
  const auto seen = [](double chroma) {
    Picture picture = {200, 40, 90};
    EyeFilter(1, 1, 0, chroma).filter(picture.data());
    return picture;
  };
  const auto luminance = [](const Picture& picture) {
    return 0.2126 * light_of(picture[0]) + 0.7152 * light_of(picture[1]) + 0.0722 * light_of(picture[2]);
  };
  const Picture full = seen(1), half = seen(0.5), none = seen(0);
  EXPECT_EQ(full, (Picture{200, 40, 90}));
  EXPECT_EQ(none[0], none[1]);
  EXPECT_EQ(none[1], none[2]);
  EXPECT_NEAR(luminance(none), luminance(full), 0.002);
  EXPECT_NEAR(luminance(half), luminance(full), 0.002);
  EXPECT_NEAR(light_of(half[0]), (light_of(200) + luminance(full)) / 2, 0.003);
}

// Pictures of one row, one column, and of less than the filter reaches.
TEST(Eyesight, TakesPicturesOfAnySize) {
  for (const auto& [height, width] : {std::pair<std::size_t, std::size_t>{1, 9}, {9, 1}, {2, 3}, {1, 1}}) {
    Picture picture(height * width * 3, 100);
    EyeFilter(height, width, 4, 0.3).filter(picture.data());
    EXPECT_EQ(picture, Picture(height * width * 3, 100));
  }
}

}  // namespace
}  // namespace mimo::observation
