#include "observation/light.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mimo::observation {
namespace {

constexpr double kRedShare = 0.2126, kBlueShare = 0.0722;  // of the luminance

// Light from black to white as 0 to 1, of levels as 0 to 1.
double linear(double coded) { return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4); }

Light share(double part, double whole) { return static_cast<Light>(std::lround(part * whole)); }

// The difference of two lights, weighed in 65536ths.
int scaled(int difference, std::int16_t weight) { return (static_cast<std::int16_t>(difference) * weight) >> 16; }

}  // namespace

LightTables::LightTables() {
  constexpr double kRange = kWhite - kBlack;
  for (std::size_t i = 0; i < 256; ++i) {
    const auto range = share(linear(static_cast<double>(i) / 255), kRange);
    light_[i] = static_cast<Light>(kBlack + range);
    red_[i] = share(kRedShare, range);
    blue_[i] = share(kBlueShare, range);
    // The rest, so that greys are exactly as bright as before.
    green_[i] = static_cast<Light>(light_[i] - red_[i] - blue_[i]);
  }
  const auto above = [](std::size_t level) {
    return kBlack + std::round(kRange * linear((static_cast<double>(level) + 0.5) / 255));
  };
  std::size_t level = 0;
  double next = above(0);
  for (std::size_t i = 0; i < level_.size(); ++i) {
    const auto middle = static_cast<double>(4 * i) + 1.5;
    while (level < 255 && middle >= next) next = above(++level);
    level_[i] = static_cast<std::uint8_t>(level);
  }
}

void LightTables::decode(const std::uint8_t* rgb, std::size_t width, Light* red, Light* green, Light* blue) const {
  for (std::size_t x = 0; x < width; ++x) {
    red[x] = light_[rgb[3 * x]];
    green[x] = light_[rgb[3 * x + 1]];
    blue[x] = light_[rgb[3 * x + 2]];
  }
}

void LightTables::encode(const Light* red, const Light* green, const Light* blue, std::size_t width,
                         std::uint8_t* rgb) const {
  for (std::size_t x = 0; x < width; ++x) {
    rgb[3 * x] = level(red[x]);
    rgb[3 * x + 1] = level(green[x]);
    rgb[3 * x + 2] = level(blue[x]);
  }
}

void LightTables::decode_grey(const std::uint8_t* rgb, std::size_t width, Light* grey) const {
  for (std::size_t x = 0; x < width; ++x) {
    const std::uint8_t* at = rgb + 3 * x;
    grey[x] = static_cast<Light>(red_[at[0]] + green_[at[1]] + blue_[at[2]]);
  }
}

// Four bytes at once, of which the next pixel writes the last one over, and four pixels a round: that takes two thirds
// of the time.
void LightTables::encode_grey(const Light* grey, std::size_t width, std::uint8_t* rgb) const {
  std::size_t x = 0;
  for (; x + 4 < width; x += 4) {
    for (std::size_t i = x; i < x + 4; ++i) {
      const std::uint32_t four = std::uint32_t{level(grey[i])} * 0x01010101U;
      std::memcpy(rgb + 3 * i, &four, 4);
    }
  }
  for (; x < width; ++x) std::fill_n(rgb + 3 * x, 3, level(grey[x]));
}

const LightTables kLightTables;

// In two halves, since 16 bits with a sign hold weights below a half; one rounds down, the other up.
void fade(Light* red, Light* green, Light* blue, std::size_t width, double grey) {
  const auto half = static_cast<std::int16_t>(std::min(std::lround(grey * 32768), 32767L));
  const auto of_red = static_cast<std::int16_t>(kRedShare * 65536);
  const auto of_blue = static_cast<std::int16_t>(kBlueShare * 65536);
  const auto towards = [half](Light from, Light to) {
    return static_cast<Light>(from + scaled(to - from, half) - scaled(from - to, half));
  };
  for (std::size_t x = 0; x < width; ++x) {
    const auto luminance =
        static_cast<Light>(green[x] + scaled(red[x] - green[x], of_red) - scaled(green[x] - blue[x], of_blue));
    red[x] = towards(red[x], luminance);
    green[x] = towards(green[x], luminance);
    blue[x] = towards(blue[x], luminance);
  }
}

}  // namespace mimo::observation
