#include "growth/curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mimo::growth {
namespace {

struct Piece {
  double width;
  double slope;
};

// At a point between two pieces: the harmonic mean of their slopes, none at a summit.
double inner_slope(const Piece& left, const Piece& right) {
  if (left.slope * right.slope <= 0) return 0;
  const double of_left = 2 * right.width + left.width, of_right = right.width + 2 * left.width;
  return (of_left + of_right) / (of_left / left.slope + of_right / right.slope);
}

// At an end: of the parabola through three points, held back where it would overshoot.
double end_slope(const Piece& end, const Piece& next) {
  const double slope = ((2 * end.width + next.width) * end.slope - end.width * next.slope) / (end.width + next.width);
  if (slope * end.slope <= 0) return 0;
  if (end.slope * next.slope <= 0 && std::abs(slope) > 3 * std::abs(end.slope)) return 3 * end.slope;
  return slope;
}

}  // namespace

Curve::Curve(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
    const double width = x_[i + 1] - x_[i];
    pieces.push_back({width, (y_[i + 1] - y_[i]) / width});
  }
  slope_.push_back(end_slope(pieces[0], pieces[1]));
  for (std::size_t i = 1; i < pieces.size(); ++i) slope_.push_back(inner_slope(pieces[i - 1], pieces[i]));
  slope_.push_back(end_slope(pieces.back(), pieces[pieces.size() - 2]));
}

double Curve::operator()(double x) const {
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const std::size_t i = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin() - 1;
  const double width = x_[i + 1] - x_[i], t = (x - x_[i]) / width, rest = 1 - t;
  // At a point t is 0, between equal points all is 0 but y.
  return y_[i] + (y_[i + 1] - y_[i]) * t * t * (3 - 2 * t) + width * t * rest * (slope_[i] * rest - slope_[i + 1] * t);
}

}  // namespace mimo::growth
