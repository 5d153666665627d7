#include "growth/eyesight.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "growth/points.h"

namespace mimo::growth {
namespace {

// Straight lines through the points' logarithms.
template <std::size_t kCount>
double between(const Point (&points)[kCount], double age) {
  const Stretch at = stretch_at(points, age);
  return at.left * std::pow(at.right / at.left, at.share);
}

// Cycles per degree, of one eye. Gratings on cards: at birth Brown and Yamamoto 1986; then the mean of Mayer et al.
// 1995, Salomao and Ventura 1995 and Teller's, weighted by their infants. Individuals lie within 0.45 octaves of it.
constexpr Point kAcuity[] = {{0, 0.70}, {1, 0.88}, {1.5, 1.11}, {2.5, 2.16}, {4, 3.09},
                             {6, 6.01}, {9, 6.52}, {12, 7.47},  {18, 8.97},  {24, 11.1}};

// Estimated between what is known: 2 at birth (Brown 2015), ten times that in a year (Teller 1997), 200 at ten years.
constexpr Point kPeakContrast[] = {{0, 2}, {1, 2.8}, {2, 5}, {3, 8}, {4, 11}, {6, 14}, {9, 17}, {12, 20}, {24, 40}};

// Estimated, from what of flicker infants of 2 to 4 months see best (Rasengane et al. 1997).
constexpr Point kFlicker[] = {{2, 4}, {4, 8}, {12, 15}};

}  // namespace

// Colour comes in from the first to the third month (Varner 1985, Suttle 1997); the line between is estimated.
Eyesight eyesight_at(double age) {
  return {between(kAcuity, age), between(kPeakContrast, age), std::clamp((age - 1) / 2, 0.0, 1.0),
          between(kFlicker, age)};
}

}  // namespace mimo::growth
