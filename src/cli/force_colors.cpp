#include "cli/force_colors.h"

#include <algorithm>
#include <cmath>

#include "cli/canvas.h"
#include "cli/lettering.h"

namespace cli {
namespace {

constexpr double kWeak = 0.1, kStrong = 10;  // N
constexpr double kStops[][3] = {{255, 235, 130}, {250, 140, 40}, {215, 25, 30}, {110, 0, 60}};
constexpr Rgb kPaper{255, 255, 255}, kInk{60, 60, 60};

}  // namespace

double strength(double newtons) {
  return std::clamp(std::log(std::max(newtons, 1e-9) / kWeak) / std::log(kStrong / kWeak), 0.0, 1.0);
}

Rgb heat(double strength) {
  const double at = std::clamp(strength, 0.0, 1.0) * 3;
  const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(at), 2);
  const double rest = at - static_cast<double>(below);
  const auto part = [&](std::size_t i) {
    return static_cast<std::uint8_t>(std::lround(kStops[below][i] * (1 - rest) + kStops[below + 1][i] * rest));
  };
  return {part(0), part(1), part(2)};
}

void draw_scale(ColorPicture& picture) {
  const double unit = picture.height / 480.0, y = picture.height - 18 * unit;
  const double length = 160 * unit, left = picture.width / 2.0 - length / 2, letters = 2 * unit;
  stroke(picture, {left - 56 * unit, y}, {left + length + 48 * unit, y}, 14 * unit, {kPaper, 0.85});
  constexpr int kPieces = 80;
  for (int i = 0; i < kPieces; ++i) {
    const double x = left + length * (i + 0.5) / kPieces;
    stroke(picture, {x, y}, {x, y}, 4 * unit, {heat((i + 0.5) / kPieces), 1});
  }
  write(picture, "0.1 N", {left - 8 * unit - width_of("0.1 N", letters), y}, letters, kInk);
  write(picture, "10 N", {left + length + 8 * unit, y}, letters, kInk);
}

}  // namespace cli
