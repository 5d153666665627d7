// Pictures as infants see them.
#include "observation/eyesight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace mimo::observation {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Light of levels and levels of light, both 0 to 1.
double decoded(double level) { return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4); }
double encoded(double light) { return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055; }

struct Picture {
  std::size_t height, width;
  std::vector<std::uint8_t> rgb = std::vector<std::uint8_t>(height * width * 3);

  // light(x, y, colour)
  void paint(const std::function<double(std::size_t, std::size_t, std::size_t)>& light) {
    for (std::size_t i = 0; i < rgb.size(); ++i) {
      const double level = encoded(light(i / 3 % width, i / 3 / width, i % 3));
      rgb[i] = static_cast<std::uint8_t>(std::lround(255 * level));
    }
  }
  double light(std::size_t x, std::size_t y, std::size_t colour) const {
    return decoded(rgb[(y * width + x) * 3 + colour] / 255.0);
  }
  double luminance(std::size_t x, std::size_t y) const {
    return 0.2126 * light(x, y, 0) + 0.7152 * light(x, y, 1) + 0.0722 * light(x, y, 2);
  }
  std::uint8_t level(std::size_t x, std::size_t y, std::size_t colour = 1) const {
    return rgb[(y * width + x) * 3 + colour];
  }
};

Eyesight grey_eyes(double acuity, double peak_contrast) {
  Eyesight eyes;
  eyes.acuity = acuity;
  eyes.peak_contrast = peak_contrast;
  return eyes;
}

void see(Picture& picture, double pixels_per_degree, const Eyesight& eyes) {
  EyeFilter(picture.height, picture.width, pixels_per_degree, eyes).filter(picture.rgb.data());
}

// Processors with long vectors decode 32 pixels at once, and what is left of a row one by one.
TEST(Light, OfManyPixelsIsThatOfEachAlone) {
  constexpr std::size_t kWidth = 32 * 256 + 31;
  std::vector<std::uint8_t> rgb(kWidth * 3);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::uint8_t>(i * 7 + i / 256 * 5 + i % 3 * 101);
  std::vector<Light> grey(kWidth), red(kWidth), green(kWidth), blue(kWidth);
  kLightTables.decode_grey(rgb.data(), kWidth, grey.data());
  kLightTables.decode(rgb.data(), kWidth, red.data(), green.data(), blue.data());
  for (std::size_t x = 0; x < kWidth; ++x) {
    const std::uint8_t* const pixel = rgb.data() + 3 * x;
    Light alone[3];
    kLightTables.decode_grey(pixel, 1, alone);
    ASSERT_EQ(grey[x], alone[0]) << x;
    kLightTables.decode(pixel, 1, alone, alone + 1, alone + 2);
    ASSERT_EQ(red[x], alone[0]) << x;
    ASSERT_EQ(green[x], alone[1]) << x;
    ASSERT_EQ(blue[x], alone[2]) << x;
  }
}

// Grey bars across x or, `turned`, across y.
Picture grating(std::size_t size, double cycles_per_pixel, double contrast, bool turned) {
  Picture picture{turned ? size : 24, turned ? 24 : size};
  picture.paint([&](std::size_t x, std::size_t y, std::size_t) {
    return 0.3 * (1 + contrast * std::sin(2 * kPi * cycles_per_pixel * static_cast<double>(turned ? y : x) + 0.4));
  });
  return picture;
}

// How much of that frequency is in the middle of a picture, edges faded out.
double strength(const Picture& picture, double cycles_per_pixel, bool turned) {
  const std::size_t size = turned ? picture.height : picture.width, quarter = size / 4;
  double weights = 0, mean = 0, sine = 0, cosine = 0;
  const auto each = [&](const std::function<void(double, double, double)>& use) {
    for (std::size_t i = quarter; i < 3 * quarter; ++i) {
      const double at = static_cast<double>(i - quarter) / static_cast<double>(2 * quarter);
      const double light = turned ? picture.light(12, i, 1) : picture.light(i, 12, 1);
      use(std::pow(std::sin(kPi * at), 2), light, 2 * kPi * cycles_per_pixel * static_cast<double>(i));
    }
  };
  each([&](double weight, double light, double) { weights += weight, mean += weight * light; });
  each([&](double weight, double light, double phase) {
    sine += weight * (light - mean / weights) * std::sin(phase);
    cosine += weight * (light - mean / weights) * std::cos(phase);
  });
  return std::hypot(sine, cosine);
}

double contrast_left(std::size_t size, double pixels_per_degree, double cycles_per_degree, const Eyesight& eyes,
                     bool turned) {
  const double cycles = cycles_per_degree / pixels_per_degree;
  Picture picture = grating(size, cycles, 0.6, turned);
  const double before = strength(picture, cycles, turned);
  see(picture, pixels_per_degree, eyes);
  return strength(picture, cycles, turned) / before;
}

TEST(EyeFilter, KeepsTheContrastsThatInfantsOfThatAgeSee) {
  const double frequencies[] = {0.1, 0.25, 0.5, 1, 2};
  struct Row {
    double age, acuity, peak_contrast, left[5];
  };
  const Row rows[] = {{0, 0.70, 2.00, {0.9860, 0.9154, 0.7021, 0.2430, 0.0035}},
                      {1, 0.88, 2.80, {0.9868, 0.9203, 0.7172, 0.2646, 0.0049}},
                      {2.5, 2.16, 6.32, {0.9961, 0.9756, 0.9059, 0.6735, 0.2057}},
                      {6, 6.01, 14.0, {0.9993, 0.9954, 0.9819, 0.9295, 0.7466}},
                      {12, 7.47, 20.0, {0.9995, 0.9967, 0.9867, 0.9477, 0.8067}},
                      {24, 11.1, 40.0, {0.9997, 0.9981, 0.9925, 0.9705, 0.8871}}};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < 5; ++i) {
      SCOPED_TRACE(std::to_string(row.age) + " months, cycles per degree: " + std::to_string(frequencies[i]));
      const Eyesight eyes = grey_eyes(row.acuity, row.peak_contrast);
      for (const std::size_t size : {64, 128, 256, 512}) {
        const double pixels_per_degree = static_cast<double>(size) / 2 / std::tan(kPi / 6) * kPi / 180;
        if (frequencies[i] > 0.4 * pixels_per_degree) continue;  // lines that such pictures cannot hold
        for (const bool turned : {false, true}) {
          EXPECT_NEAR(contrast_left(size, pixels_per_degree, frequencies[i], eyes, turned), row.left[i], 0.02) << size;
        }
      }
    }
  }
}

// What the eye leaves at any frequency, S^-(f/A)^2, up to 0.4 cycles per pixel: all widths of the filter. Bytes alone
// are 0.01 off.
TEST(EyeFilter, AttenuatesFineGratingsByTheFormula) {
  for (double sigma = 0.1; sigma < 1.5; sigma += 0.05) {
    Eyesight eyes = grey_eyes(1, 4);
    const double pixels_per_degree = sigma / eyes.sigma();
    for (const double cycles : {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.3877, 0.4}) {
      const double expected = std::pow(4, -std::pow(cycles * pixels_per_degree, 2));
      for (const bool turned : {false, true}) {
        EXPECT_NEAR(contrast_left(256, pixels_per_degree, cycles * pixels_per_degree, eyes, turned), expected, 0.015)
            << sigma << " pixels, " << cycles;
      }
    }
  }
}

// A limit that leaves half of so fine lines, alone and in front of an eye.
TEST(EyeFilter, AppliesTheBlurFirst) {
  Eyesight veil;
  veil.blur = 0.5;
  EXPECT_NEAR(contrast_left(256, 8, 0.5, veil, false), 0.5, 0.01);
  veil.acuity = 0.5;
  EXPECT_NEAR(contrast_left(256, 8, 0.5, veil, false), 0.25, 0.01);
}

TEST(EyeFilter, HasHalfTheContrastAtANewbornsAcuity) {
  EXPECT_NEAR(contrast_left(256, 8, 0.5, grey_eyes(0.5, 2), false), 0.5, 0.01);
  EXPECT_NEAR(contrast_left(256, 8, 1, grey_eyes(0.5, 2), false), 0.0625, 0.01);
  EXPECT_NEAR(contrast_left(256, 8, 0.25, grey_eyes(0.5, 2), false), 0.841, 0.01);
}

TEST(EyeFilter, LeavesPicturesAloneWherePerfect) {
  EXPECT_FALSE(Eyesight{}.any());
  Picture picture{8, 8};
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = static_cast<std::uint8_t>(i * 37);
  const Picture before = picture;
  see(picture, 4, Eyesight{});
  EXPECT_EQ(picture.rgb, before.rgb);
}

// Any level, any kernel, with and without thresholds; also of pictures smaller than the kernel.
TEST(EyeFilter, LeavesEvenColours) {
  for (const double acuity : {0.02, 0.05, 0.3, 0.7, 2.0, 8.0}) {
    for (const bool threshold : {false, true}) {
      Eyesight eyes = grey_eyes(acuity, 3);
      eyes.threshold = threshold;
      EyeFilter filter(20, 33, 4.3, eyes);
      for (std::size_t level = 0; level < 256; ++level) {
        Picture picture{20, 33};
        for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
          picture.rgb[i] = static_cast<std::uint8_t>(level + 40 * (i % 3));
        }
        const Picture before = picture;
        filter.filter(picture.rgb.data());
        ASSERT_EQ(picture.rgb, before.rgb) << acuity << " " << level;
      }
    }
  }
}

// Mean light of small dots on a dark and on a bright ground, as a level.
TEST(EyeFilter, KeepsTheMeanLevel) {
  for (const double ground : {0.002, 0.02, 0.2, 0.6}) {
    for (const double acuity : {0.1, 0.3, 0.7, 2.0, 8.0}) {
      Picture picture{96, 96};
      picture.paint([&](std::size_t x, std::size_t y, std::size_t) {
        const bool middle = x > 30 && x < 66 && y > 30 && y < 66;
        return ground * (middle && (x * 7 + y * 3) % 5 < 2 ? 1.6 : 1);
      });
      const auto mean = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < 96 * 96; ++i) sum += picture.light(i % 96, i / 96, 1);
        return 255 * encoded(sum / (96 * 96));
      };
      const double before = mean();
      see(picture, 3.869, grey_eyes(acuity, 2));
      EXPECT_NEAR(mean(), before, 0.5) << ground << " " << acuity;
    }
  }
}

// Between black and white nothing becomes darker or brighter than what is there, nor does it go up and down.
TEST(EyeFilter, MakesNoRingsAtEdges) {
  for (double sigma = 0.1; sigma < 6; sigma += 0.1) {
    Picture picture{3, 96};
    picture.paint([](std::size_t x, std::size_t, std::size_t) { return x < 48 ? 0.02 : 0.7; });
    see(picture, sigma, grey_eyes(std::sqrt(std::log(2.0) / 2) / kPi, 2));
    EXPECT_EQ(picture.level(0, 1), std::lround(255 * encoded(0.02)));
    for (std::size_t x = 1; x < 96; ++x) ASSERT_GE(picture.level(x, 1), picture.level(x - 1, 1)) << sigma << " " << x;
  }
}

Picture colourful() {
  Picture picture{16, 256};
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    picture.rgb[i] = static_cast<std::uint8_t>((i / 3 % 256 * (i % 3 + 1) + i / 3 / 256 * 16 * (3 - i % 3)) & 255);
  }
  return picture;
}

TEST(EyeFilter, RemovesColourAndKeepsLuminance) {
  for (const double chroma : {0.0, 1e-9, 0.25, 0.5, 0.8}) {
    const Picture before = colourful();
    Picture picture = before;
    Eyesight eyes;
    eyes.chroma = chroma;
    see(picture, 4, eyes);
    for (std::size_t y = 0; y < 16; ++y) {
      for (std::size_t x = 0; x < 256; ++x) {
        // Half a level of rounding in each colour.
        const double luminance = before.luminance(x, y);
        ASSERT_NEAR(255 * encoded(picture.luminance(x, y)), 255 * encoded(luminance), 1);
        for (std::size_t c = 0; c < 3; ++c) {
          const double light = luminance + chroma * (before.light(x, y, c) - luminance);
          ASSERT_NEAR(picture.level(x, y, c), 255 * encoded(light), 0.8) << chroma << " " << x << " " << y;
        }
        if (chroma == 0) {
          ASSERT_EQ(picture.level(x, y, 0), picture.level(x, y, 1));
          ASSERT_EQ(picture.level(x, y, 2), picture.level(x, y, 1));
        }
      }
    }
  }
}

TEST(EyeFilter, LeavesGreyGrey) {
  for (const double chroma : {0.0, 0.3, 1.0}) {
    for (const double acuity : {0.0, 0.7, 5.0}) {
      Picture picture{4, 256};
      for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        picture.rgb[i] = static_cast<std::uint8_t>(i / 3 % 256 * 5 % 256);
      }
      const Picture before = picture;
      Eyesight eyes = grey_eyes(acuity, 2);
      eyes.chroma = chroma;
      see(picture, 3.869, eyes);
      for (std::size_t x = 0; x < 256; ++x) {
        ASSERT_EQ(picture.level(x, 2, 0), picture.level(x, 2, 1)) << chroma << " " << acuity;
        ASSERT_EQ(picture.level(x, 2, 2), picture.level(x, 2, 1)) << chroma << " " << acuity;
      }
      if (acuity == 0) {
        ASSERT_EQ(picture.rgb, before.rgb) << chroma;
      }
    }
  }
}

TEST(EyeFilter, IsAsSensitiveAsInfantsAre) {
  const double frequencies[] = {0.05, 0.1, 0.25, 0.5, 1, 2, 4};
  const double newborn[] = {1.16, 1.66, 2.00, 1.48, 0.55, 0.10, 0.01};
  const double year[] = {3.46, 7.16, 13.91, 18.36, 19.98, 13.63, 4.69};
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(sensitivity(grey_eyes(0.7, 2), frequencies[i]), newborn[i], 0.006);
    EXPECT_NEAR(sensitivity(grey_eyes(7.47, 20), frequencies[i]), year[i], 0.006);
  }
}

// A grating in the middle of a band that is just too faint is gone; a little stronger, it is as without a threshold.
TEST(EyeFilter, LosesContrastsBelowTheThreshold) {
  constexpr double kPixelsPerDegree = 3.869;
  struct Case {
    double acuity, peak_contrast;
    std::size_t band;
  };
  for (const Case& eye :
       {Case{0.7, 2, 2}, Case{0.7, 2, 3}, Case{2.434, 8, 0}, Case{2.434, 8, 1}, Case{2.434, 8, 2}, Case{6.01, 14, 1}}) {
    SCOPED_TRACE(std::to_string(eye.acuity) + ", band " + std::to_string(eye.band));
    const double cycles = Bands::middle(eye.band);
    Eyesight eyes = grey_eyes(eye.acuity, eye.peak_contrast);
    const double least = 1 / sensitivity(eyes, cycles * kPixelsPerDegree);
    for (const bool turned : {false, true}) {
      const auto picture = [&](double contrast) {
        Picture made{256, 256};
        made.paint([&](std::size_t x, std::size_t y, std::size_t) {
          return 0.4 * (1 + contrast * least * std::sin(2 * kPi * cycles * static_cast<double>(turned ? y : x)));
        });
        return made;
      };
      eyes.threshold = true;
      Picture faint = picture(0.9), strong = picture(1.1);
      see(faint, kPixelsPerDegree, eyes);
      see(strong, kPixelsPerDegree, eyes);
      eyes.threshold = false;
      Picture blurred = picture(1.1);
      see(blurred, kPixelsPerDegree, eyes);
      const double amplitude = strength(blurred, cycles, turned);
      EXPECT_LT(strength(faint, cycles, turned), 0.05 * amplitude);
      EXPECT_NEAR(strength(strong, cycles, turned), amplitude, 0.1 * amplitude);
      for (std::size_t i = 64; i < 192; ++i) {
        EXPECT_NEAR(faint.light(turned ? 128 : i, turned ? i : 128, 1), 0.4, 0.4 * 0.05 * least + 0.006);
      }
    }
  }
}

// A picture that becomes brighter is seen to do so as 1 - exp(-t / tau), tau = 1 / (2 pi cut-off).
TEST(EyeFilter, FollowsChangesSlowly) {
  for (const double chroma : {0.0, 1.0}) {
    Eyesight eyes;
    eyes.chroma = chroma;
    eyes.flicker = 4;
    EyeFilter filter(5, 7, 4, eyes);
    ASSERT_TRUE(filter.remembers());
    filter.advance(0.01);
    const auto seen = [&](double light) {
      Picture picture{5, 7};
      picture.paint([&](std::size_t, std::size_t, std::size_t) { return light; });
      filter.filter(picture.rgb.data());
      return picture.light(3, 2, 1);
    };
    EXPECT_NEAR(seen(0.1), 0.1, 0.002);  // the first picture is all that there is
    for (int step = 1; step < 30; ++step) {
      const double part = 1 - std::exp(-0.01 * step * 2 * kPi * 4);
      ASSERT_NEAR(seen(0.8), 0.1 + 0.7 * part, 0.005) << step;
    }
    filter.advance(0.05);
    EXPECT_NEAR(seen(0.1), 0.1 + 0.7 * std::exp(-0.05 * 2 * kPi * 4), 0.006);
    filter.begin();
    EXPECT_NEAR(seen(0.5), 0.5, 0.003);
  }
}

TEST(EyeFilter, GlancesWithoutRemembering) {
  Eyesight eyes = grey_eyes(0.7, 2);
  eyes.flicker = 4;
  EyeFilter filter(16, 256, 4, eyes), other(16, 256, 4, eyes);
  for (EyeFilter* it : {&filter, &other}) it->advance(0.01);
  Picture dark{16, 256}, first = colourful(), second = colourful();
  filter.glance(dark.rgb.data());
  filter.filter(first.rgb.data());
  Picture now{16, 256}, then{16, 256};
  filter.glance(now.rgb.data());
  filter.filter(then.rgb.data());
  EXPECT_EQ(now.rgb, then.rgb);
  other.filter(second.rgb.data());
  EXPECT_EQ(first.rgb, second.rgb);
}

TEST(EyeFilter, ContinuesFromASavedState) {
  Eyesight eyes = grey_eyes(0.7, 2);
  eyes.flicker = 4;
  EyeFilter first(16, 256, 4, eyes), second(16, 256, 4, eyes);
  for (EyeFilter* filter : {&first, &second}) filter->advance(0.01);
  Picture before = colourful();
  first.filter(before.rgb.data());

  ByteWriter count;
  first.save(count);
  std::vector<std::uint8_t> bytes(count.size());
  ByteWriter to{Span<std::uint8_t>(bytes)};
  first.save(to);
  ByteReader from{Span<const std::uint8_t>(bytes)};
  second.load(from);
  EXPECT_EQ(from.left(), 0U);

  Picture one{16, 256}, other{16, 256};
  first.filter(one.rgb.data());
  second.filter(other.rgb.data());
  EXPECT_EQ(one.rgb, other.rgb);
  EXPECT_NE(one.rgb, Picture({16, 256}).rgb);

  std::fill(bytes.begin() + 1, bytes.end(), std::uint8_t{255});  // no numbers
  ByteReader broken{Span<const std::uint8_t>(bytes)};
  EXPECT_ANY_THROW(second.load(broken));
  Picture after = colourful(), fresh = colourful();
  second.filter(after.rgb.data());
  EyeFilter(16, 256, 4, eyes).filter(fresh.rgb.data());
  EXPECT_EQ(after.rgb, fresh.rgb);
}

}  // namespace
}  // namespace mimo::observation
