#include "cli/canvas.h"

#include <algorithm>
#include <cmath>

namespace cli {
namespace {

double distance_to_line(Spot p, Spot from, Spot to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double square = dx * dx + dy * dy;
  const double share = square > 0 ? std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - from.x - share * dx, p.y - from.y - share * dy);
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, double share) {
  return static_cast<std::uint8_t>(std::lround(below + (above - below) * share));
}

// The pixels that a stroke between two coordinates may touch, along one axis.
struct Range {
  long begin, end;
};
Range touched(double a, double b, double margin, std::uint32_t size) {
  const double low = std::clamp(std::min(a, b) - margin, 0.0, static_cast<double>(size));
  const double high = std::clamp(std::max(a, b) + margin, 0.0, static_cast<double>(size));
  return {static_cast<long>(std::floor(low)), static_cast<long>(std::ceil(high))};
}

}  // namespace

void stroke(ColorPicture& picture, Spot from, Spot to, double radius, const Ink& ink) {
  const Range columns = touched(from.x, to.x, radius + 1, picture.width);
  const Range rows = touched(from.y, to.y, radius + 1, picture.height);
  for (long y = rows.begin; y < rows.end; ++y) {
    for (long x = columns.begin; x < columns.end; ++x) {
      const Spot middle{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
      const double cover = ink.opacity * std::clamp(radius + 0.5 - distance_to_line(middle, from, to), 0.0, 1.0);
      if (cover <= 0) continue;
      Rgb& pixel = picture.pixels[static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x)];
      pixel = {mixed(pixel.r, ink.color.r, cover), mixed(pixel.g, ink.color.g, cover),
               mixed(pixel.b, ink.color.b, cover)};
    }
  }
}

void arrow(ColorPicture& picture, Spot from, Spot to, double radius, const Ink& ink, double rim) {
  stroke(picture, from, to, radius + rim, ink);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length < 1) return;
  const double head = std::min(6 * radius, 0.5 * length);
  const double along = std::atan2(from.y - to.y, from.x - to.x);
  for (const double turn : {-0.45, 0.45}) {
    stroke(picture, to, {to.x + head * std::cos(along + turn), to.y + head * std::sin(along + turn)}, radius + rim,
           ink);
  }
}

}  // namespace cli
