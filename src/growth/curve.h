// A smooth curve through given points.
#pragma once

#include <array>
#include <cstddef>

namespace mimo::growth {

// The monotone cubic of Fritsch and Butland (1984): rises where the points rise, goes exactly through each of them and
// has a steady slope. Left and right of the points it keeps their values.
template <std::size_t points>
class Curve {
 public:
  // At least three points; x rises.
  constexpr Curve(const double (&x)[points], const double (&y)[points]) {
    for (std::size_t i = 0; i < points; ++i) {
      x_[i] = x[i];
      y_[i] = y[i];
    }
    find_slopes();
  }
  constexpr Curve(const std::array<double, points>& x, const std::array<double, points>& y) : x_(x), y_(y) {
    find_slopes();
  }

  constexpr double operator()(double x) const {
    if (x <= x_.front()) return y_.front();
    if (x >= x_.back()) return y_.back();
    std::size_t i = 0;
    while (x_[i + 1] <= x) ++i;
    const double width = x_[i + 1] - x_[i], t = (x - x_[i]) / width, rest = 1 - t;
    // At a point t is 0, between equal points all is 0 but y.
    return y_[i] + (y_[i + 1] - y_[i]) * t * t * (3 - 2 * t) +
           width * t * rest * (slope_[i] * rest - slope_[i + 1] * t);
  }

 private:
  static_assert(points >= 3);
  struct Piece {
    double width, slope;
  };

  constexpr Piece piece(std::size_t i) const {
    const double width = x_[i + 1] - x_[i];
    return {width, (y_[i + 1] - y_[i]) / width};
  }

  // At a point between two pieces: the harmonic mean of their slopes, none at a summit.
  static constexpr double inner_slope(const Piece& left, const Piece& right) {
    if (left.slope * right.slope <= 0) return 0;
    const double of_left = 2 * right.width + left.width, of_right = right.width + 2 * left.width;
    return (of_left + of_right) / (of_left / left.slope + of_right / right.slope);
  }

  // At an end: of the parabola through three points, held back where it would overshoot.
  static constexpr double end_slope(const Piece& end, const Piece& next) {
    const double slope = ((2 * end.width + next.width) * end.slope - end.width * next.slope) / (end.width + next.width);
    if (slope * end.slope <= 0) return 0;
    const double most = 3 * end.slope;
    if (end.slope * next.slope <= 0 && (most > 0 ? slope > most : slope < most)) return most;
    return slope;
  }

  constexpr void find_slopes() {
    slope_[0] = end_slope(piece(0), piece(1));
    for (std::size_t i = 1; i + 1 < points; ++i) slope_[i] = inner_slope(piece(i - 1), piece(i));
    slope_[points - 1] = end_slope(piece(points - 2), piece(points - 3));
  }

  std::array<double, points> x_{}, y_{}, slope_{};
};

}  // namespace mimo::growth
