// What infants of an age measure and weigh, after the WHO, how far that is from the 18-month body, and smooth curves
// through numbers that are known at some ages.
#pragma once

#include <array>
#include <cstddef>

#include "growth/growth.h"

namespace mimo::growth {

// What infants of an age measure and weigh, after the WHO, and how far that is from the 18-month body.

// What infants of an age measure and weigh, after the WHO.

enum class Measure { kLength, kWeight, kHead };  // cm, kg, cm (circumference)

// Of an infant that is z standard deviations from the median of its age, 0 to 24 months, and sex. Of the mean of the
// sexes: the mean of a girl's and a boy's that are z from their medians.
double who(Measure measure, Sex sex, double age, double z);

// The WHO's child growth standards by month, from birth to 24 months: for each sex and measure the numbers L, M and S
// of which a value is made. Lengths are those of lying infants.
//
// WHO Multicentre Growth Reference Study Group: WHO Child Growth Standards. World Health Organization, 2006 (length,
// weight) and 2007 (head circumference).

using Monthly = std::array<double, 25>;
using LmsTable = std::array<Monthly, 3>;  // L, M, S

extern const LmsTable kLengthFemale, kLengthMale;  // M in cm
extern const LmsTable kWeightFemale, kWeightMale;  // M in kg
extern const LmsTable kHeadFemale, kHeadMale;      // M in cm

// Percentiles of a normal distribution, as parents know them from growth charts.

// Standard deviations from the median. Throws Status::kInvalidArgument for a percentile that is further away than
// kMostZ.
double z_of_percentile(double percentile);

// What drives growth: length, slenderness and head, over those of the 18-month body.

constexpr double kBase = 18;  // months: the age of the body that others grow from

struct Drivers {
  double length;  // cm, as the WHO's
  double weight;  // kg
  double head;    // circumference, cm
  // Over the same of 18 months, mean of the sexes, median.
  double l;
  double w;  // of weight over length
  double h;
  double mass;  // of weight
  double
      frame;  // w of an infant whose weight is as far from the median as its length: of bones, which fat leaves alone
};

Drivers drivers(const Growth& growth);

// Of the median there, cm.
double length_at_18_months();
// Median length at an age over that at 18 months.
double median_length_ratio(double age);

// A smooth curve through given points.

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
