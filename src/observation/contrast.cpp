#include "observation/contrast.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/functions.h"
#include "observation/many_lookups.h"

namespace mimo::observation {
namespace {

constexpr double kRedShare = 0.2126, kBlueShare = 0.0722;  // of the luminance

// Light from black to white as 0 to 1, of levels as 0 to 1.
double linear(double coded) { return coded <= 0.04045 ? coded / 12.92 : fixed::pow((coded + 0.055) / 1.055, 2.4); }

Light share(double part, double whole) { return static_cast<Light>(std::lround(part * whole)); }

// The difference of two lights, weighed in 65536ths.
int scaled(int difference, std::int16_t weight) { return (static_cast<std::int16_t>(difference) * weight) >> 16; }

// A half-band low-pass: the middle has 1/2, pixels 1, 3, 5 and 7 away have these, all others nothing. Up to 0.177
// cycles per pixel (the middle of the next band) all is left within 0.016, from 0.323 on nothing is.
constexpr float kSides[] = {1272.0F / 4096, -340.0F / 4096, 129.0F / 4096, -37.0F / 4096};
constexpr std::size_t kFar = 7;

// Pixels to all sides over which something that is seen keeps its band: a grating's dark stripes are near its bright
// ones, and what lies between is no less seen.
constexpr std::size_t kNear = 3;

std::size_t before(std::size_t at, std::size_t by) { return at > by ? at - by : 0; }
std::size_t after(std::size_t at, std::size_t by, std::size_t count) { return std::min(at + by, count - 1); }

// `row` with kFar pixels more at both ends.
const float* extended(const float* row, std::size_t width, std::vector<float>& room) {
  std::fill_n(room.begin(), kFar, row[0]);
  std::copy_n(row, width, room.begin() + kFar);
  std::fill_n(room.begin() + kFar + width, kFar, row[width - 1]);
  return room.data() + kFar;
}

// sum = factor * (a + b), or is that much more.
void pair(const float* a, const float* b, float factor, std::size_t count, float* __restrict sum) {
  for (std::size_t i = 0; i < count; ++i) sum[i] += factor * (a[i] + b[i]);
}

void halve_row(const float* from, std::size_t width, float* __restrict to) {
  for (std::size_t x = 0; x < width; ++x) {
    const float* at = from + 2 * x;
    to[x] = 0.5F * at[0] + kSides[0] * (at[-1] + at[1]) + kSides[1] * (at[-3] + at[3]) + kSides[2] * (at[-5] + at[5]) +
            kSides[3] * (at[-7] + at[7]);
  }
}

// Twice as many pixels, or one less.
void enlarge_row(const float* from, std::size_t width, float* __restrict to) {
  for (std::size_t x = 0; x < width / 2; ++x) {
    const float* at = from + x;
    to[2 * x] = at[0];
    to[2 * x + 1] = 2 * (kSides[0] * (at[0] + at[1]) + kSides[1] * (at[-1] + at[2]) + kSides[2] * (at[-2] + at[3]) +
                         kSides[3] * (at[-3] + at[4]));
  }
  if (width % 2 == 1) to[width - 1] = from[width / 2];
}

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
    level_[i] = static_cast<std::uint32_t>(level) * 0x01010101U;
  }
}

void LightTables::decode(const std::uint8_t* rgb, std::size_t width, Light* red, Light* green, Light* blue) const {
  for (std::size_t x = look_up_many(rgb, width, light_, red, green, blue); x < width; ++x) {
    red[x] = light_[rgb[3 * x]];
    green[x] = light_[rgb[3 * x + 1]];
    blue[x] = light_[rgb[3 * x + 2]];
  }
}

void LightTables::encode(const Light* red, const Light* green, const Light* blue, std::size_t width,
                         std::uint8_t* rgb) const {
  for (std::size_t x = 0; x < width; ++x) {
    rgb[3 * x] = static_cast<std::uint8_t>(level(red[x]));
    rgb[3 * x + 1] = static_cast<std::uint8_t>(level(green[x]));
    rgb[3 * x + 2] = static_cast<std::uint8_t>(level(blue[x]));
  }
}

void LightTables::decode_grey(const std::uint8_t* rgb, std::size_t width, Light* grey) const {
  for (std::size_t x = add_up_many(rgb, width, red_, green_, blue_, grey); x < width; ++x) {
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
      const std::uint32_t four = level(grey[i]);
      std::memcpy(rgb + 3 * i, &four, 4);
    }
  }
  for (; x < width; ++x) std::fill_n(rgb + 3 * x, 3, static_cast<std::uint8_t>(level(grey[x])));
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

std::size_t Bands::number(std::size_t height, std::size_t width) {
  std::size_t number = 0;
  for (std::size_t size = std::min(height, width); size >= 16; size = (size + 1) / 2) ++number;
  return number;
}

double Bands::middle(std::size_t band) { return std::ldexp(std::sqrt(0.125), -static_cast<int>(band)); }

Bands::Bands(std::size_t height, std::size_t width, const std::vector<double>& least) {
  if (least.empty()) return;
  for (std::size_t band = 0; band <= least.size(); ++band) {
    Level level{};
    level.height = height;
    level.width = width;
    level.light.resize(height * width);
    level.change.resize(height * width);
    if (band < least.size()) {
      level.least = static_cast<float>(least[band]);
      level.coarse.resize(height * width);
      level.seen.resize(height * width);
      level.along.resize(height * width);
    }
    levels_.push_back(level);
    height = (height + 1) / 2;
    width = (width + 1) / 2;
  }
  room_.resize(levels_[0].light.size());
  row_.resize(levels_[0].width + 2 * kFar);
}

void Bands::halve(const Level& from, Level& to) {
  const std::size_t width = from.width;
  for (std::size_t y = 0; y < to.height; ++y) {
    const auto row = [&](std::size_t at) { return from.light.data() + at * width; };
    float* sum = room_.data();
    for (std::size_t x = 0; x < width; ++x) sum[x] = 0.5F * row(2 * y)[x];
    for (std::size_t k = 0; k < 4; ++k) {
      pair(row(before(2 * y, 2 * k + 1)), row(after(2 * y, 2 * k + 1, from.height)), kSides[k], width, sum);
    }
    halve_row(extended(sum, width, row_), to.width, to.light.data() + y * to.width);
  }
}

void Bands::enlarge(const std::vector<float>& small, const Level& from, const Level& to, std::vector<float>& large) {
  const std::size_t width = from.width;
  for (std::size_t y = 0; y < to.height; ++y) {
    const auto row = [&](std::size_t at) { return small.data() + at * width; };
    const std::size_t at = y / 2;
    const float* sum = row(at);
    if (y % 2 == 1) {
      std::fill_n(room_.begin(), width, 0.0F);
      for (std::size_t k = 0; k < 4; ++k) {
        pair(row(before(at, k)), row(after(at, k + 1, from.height)), 2 * kSides[k], width, room_.data());
      }
      sum = room_.data();
    }
    enlarge_row(extended(sum, width, row_), to.width, large.data() + y * to.width);
  }
}

// First along the rows, then along the columns.
void Bands::find_seen(Level& level) {
  const std::size_t width = level.width;
  std::fill(level.along.begin(), level.along.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < level.light.size(); ++i) {
    level.seen[i] = std::abs(level.light[i] - level.coarse[i]) >= level.least * level.coarse[i] ? 1 : 0;
  }
  for (std::size_t y = 0; y < level.height; ++y) {
    const std::uint8_t* seen = level.seen.data() + y * width;
    std::uint8_t* along = level.along.data() + y * width;
    for (std::size_t k = 0; k <= std::min(kNear, width - 1); ++k) {
      for (std::size_t x = 0; x + k < width; ++x) along[x] |= seen[x + k];
      for (std::size_t x = 0; x + k < width; ++x) along[x + k] |= seen[x];
    }
  }
  for (std::size_t y = 0; y < level.height; ++y) {
    std::uint8_t* seen = level.seen.data() + y * width;
    std::fill_n(seen, width, std::uint8_t{0});
    for (std::size_t from = before(y, kNear); from <= after(y, kNear, level.height); ++from) {
      const std::uint8_t* along = level.along.data() + from * width;
      for (std::size_t x = 0; x < width; ++x) seen[x] |= along[x];
    }
  }
}

void Bands::clear_unseen(float* light) {
  std::copy_n(light, levels_[0].light.size(), levels_[0].light.begin());
  for (std::size_t i = 0; i + 1 < levels_.size(); ++i) halve(levels_[i], levels_[i + 1]);
  for (std::size_t i = levels_.size() - 1; i-- > 0;) {
    Level &level = levels_[i], &next = levels_[i + 1];
    enlarge(next.light, next, level, level.coarse);
    find_seen(level);
    enlarge(next.change, next, level, level.change);
    for (std::size_t at = 0; at < level.light.size(); ++at) {
      level.change[at] += static_cast<float>(1 - level.seen[at]) * (level.coarse[at] - level.light[at]);
    }
  }
  for (std::size_t i = 0; i < levels_[0].light.size(); ++i) light[i] += levels_[0].change[i];
}

}  // namespace mimo::observation
