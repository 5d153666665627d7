#include "observation/foveation.h"

#include <algorithm>
#include <cmath>

#include "base/functions.h"
#include "base/numbers.h"

namespace mimo::observation {
namespace {

constexpr std::size_t kColours = 3;

// A row or column of half the size: old pixels -1, 0, 1 and 2 of each new one weigh 1, 3, 3 and 1.
Light halved(Light a, Light b, Light c, Light d) { return static_cast<Light>((a + 3 * (b + c) + d + 4) >> 3); }

std::array<std::size_t, 4> four_of(std::size_t at, std::size_t count) {
  const std::size_t first = 2 * at;
  return {first > 0 ? first - 1 : 0, first, std::min(first + 1, count - 1), std::min(first + 2, count - 1)};
}

// The columns of `from` halved, then its rows, both in `to`; `row` is room for a row.
void halve(const Light* from, std::size_t height, std::size_t width, std::vector<Light>& row, Light* to) {
  for (std::size_t y = 0; y < (height + 1) / 2; ++y) {
    const auto [a, b, c, d] = four_of(y, height);
    for (std::size_t x = 0; x < width; ++x) {
      row[x] = halved(from[a * width + x], from[b * width + x], from[c * width + x], from[d * width + x]);
    }
    for (std::size_t x = 0; x < (width + 1) / 2; ++x) {
      const auto [e, f, g, h] = four_of(x, width);
      *to++ = halved(row[e], row[f], row[g], row[h]);
    }
  }
}

// Between which two of `count` pixels a place lies, and how far, in 256ths.
struct Between {
  std::size_t from, to;
  std::uint32_t part;
};

Between between(std::int32_t place, std::size_t count) {
  const std::int32_t last = static_cast<std::int32_t>(count - 1);
  const std::int32_t inside = std::clamp(place, 0, last * 256);
  const std::int32_t from = inside >> 8;
  return {static_cast<std::size_t>(from), static_cast<std::size_t>(std::min(from + 1, last)),
          static_cast<std::uint32_t>(inside & 255)};
}

// Of one colour of a picture.
std::uint32_t light_at(const Light* colour, std::size_t width, const Between& x, const Between& y) {
  const auto in_row = [&](std::size_t row) {
    const Light* at = colour + row * width;
    return at[x.from] * (256 - x.part) + at[x.to] * x.part;
  };
  return (in_row(y.from) * (256 - y.part) + in_row(y.to) * y.part + 32768) >> 16;
}

}  // namespace

FovealMap::FovealMap(std::size_t height, std::size_t width, const Pinhole& pinhole, double strength)
    : strength_(strength),
      middle_x_(static_cast<double>(width - 1) / 2),
      middle_y_(static_cast<double>(height - 1) / 2),
      corner_(length_of(middle_x_, middle_y_)),
      pinhole_(pinhole) {}

double FovealMap::distance(Place place) const { return length_of(place[0] - middle_x_, place[1] - middle_y_); }

FovealMap::Place FovealMap::scaled(Place place, double factor) const {
  return {middle_x_ + factor * (place[0] - middle_x_), middle_y_ + factor * (place[1] - middle_y_)};
}

double FovealMap::shrinkage(double r) const {
  return even() ? 1 : fixed::log1p(strength_) / strength_ * fixed::exp(r / corner_ * fixed::log1p(strength_));
}

FovealMap::Place FovealMap::plain(Place foveated) const {
  const double r = distance(foveated);
  if (even() || r == 0) return foveated;
  return scaled(foveated, corner_ * fixed::expm1(r / corner_ * fixed::log1p(strength_)) / strength_ / r);
}

FovealMap::Place FovealMap::foveated(Place plain) const {
  const double r = distance(plain);
  if (even() || r == 0) return plain;
  return scaled(plain, corner_ * fixed::log1p(strength_ * r / corner_) / fixed::log1p(strength_) / r);
}

std::array<double, 3> FovealMap::direction(Place foveated) const {
  if (pinhole_.parallel) return {0, 0, -1};
  const Place at = plain(foveated);
  const double ahead = pinhole_.focal_y;  // pixels may be wider than they are high
  const double right = (at[0] + 0.5 - pinhole_.center_x) * (ahead / pinhole_.focal_x);
  const double down = at[1] + 0.5 - pinhole_.center_y;
  const double length = std::sqrt(right * right + down * down + ahead * ahead);
  return {right / length, -down / length, -ahead / length};
}

std::optional<FovealMap::Place> FovealMap::place(const std::array<double, 3>& direction) const {
  if (pinhole_.parallel || !(direction[2] < 0)) return std::nullopt;
  return foveated({pinhole_.center_x - 0.5 + pinhole_.focal_x * direction[0] / -direction[2],
                   pinhole_.center_y - 0.5 + pinhole_.focal_y * direction[1] / direction[2]});
}

FovealMap map_of(const Field& picture) {
  return {picture.shape[0], picture.shape[1], picture.pinhole, picture.foveation};
}

Foveation::Foveation(std::size_t height, std::size_t width, const FovealMap& map)
    : height_(height), width_(width), map_(map) {
  const auto levels = static_cast<std::size_t>(std::max(0.0, std::ceil(fixed::log2(map.shrinkage(map.corner()))))) + 1;
  for (std::size_t i = 0; i < height_ * width_; ++i) sources_.push_back(source(i % width_, i / width_));
  row_.resize(kColours * width_);
  for (std::size_t i = 0; i < levels; ++i) {
    levels_.push_back({height, width, std::vector<Light>(kColours * height * width)});
    height = (height + 1) / 2;
    width = (width + 1) / 2;
  }
}

// Rounded, so that the last bit of a library's exp is lost. Along the radius, where it shrinks most.
Foveation::Source Foveation::source(std::size_t x, std::size_t y) const {
  const FovealMap::Place here = {static_cast<double>(x), static_cast<double>(y)}, from = map_.plain(here);
  const double level = std::max(0.0, fixed::log2(map_.shrinkage(map_.distance(here))));
  return {static_cast<std::int32_t>(std::lround(256 * from[0])), static_cast<std::int32_t>(std::lround(256 * from[1])),
          static_cast<std::uint32_t>(std::lround(256 * level))};
}

void Foveation::filter(std::uint8_t* rgb) {
  read(rgb);
  Light *red = row_.data(), *green = red + width_, *blue = green + width_;
  for (std::size_t y = 0; y < height_; ++y) {
    for (std::size_t x = 0; x < width_; ++x) sample(sources_[y * width_ + x], red + x);
    kLightTables.encode(red, green, blue, width_, rgb + y * width_ * kColours);
  }
}

void Foveation::read(const std::uint8_t* rgb) {
  const std::size_t count = height_ * width_;
  for (std::size_t y = 0; y < height_; ++y) {
    Light* red = levels_[0].light.data() + y * width_;
    kLightTables.decode(rgb + y * width_ * kColours, width_, red, red + count, red + 2 * count);
  }
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    const Level& from = levels_[i - 1];
    Level& to = levels_[i];
    for (std::size_t colour = 0; colour < kColours; ++colour) {
      halve(from.light.data() + colour * from.height * from.width, from.height, from.width, row_,
            to.light.data() + colour * to.height * to.width);
    }
  }
}

// Adds what of a pixel comes from one level; `share` is in 256ths.
void Foveation::add(const Source& source, std::size_t number, std::uint32_t share, std::uint32_t* sum) const {
  const Level& level = levels_[number];
  // A pixel's middle is half a pixel from its edge in every level.
  const auto place = [number](std::int32_t at) { return ((at + 128) >> number) - 128; };
  const Between x = between(place(source.x), level.width), y = between(place(source.y), level.height);
  for (std::size_t colour = 0; colour < kColours; ++colour) {
    const Light* light = level.light.data() + colour * level.height * level.width;
    sum[colour] += share * light_at(light, level.width, x, y);
  }
}

void Foveation::sample(const Source& source, Light* out) const {
  std::uint32_t sum[kColours] = {128, 128, 128};
  const std::size_t level = source.level >> 8;
  const std::uint32_t part = source.level & 255;
  add(source, level, 256 - part, sum);
  if (part > 0) add(source, level + 1, part, sum);
  for (std::size_t colour = 0; colour < kColours; ++colour) out[colour * width_] = static_cast<Light>(sum[colour] >> 8);
}

}  // namespace mimo::observation
