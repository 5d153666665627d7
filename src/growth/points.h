// Numbers that are known at some ages.
#pragma once

#include <cstddef>

namespace mimo::growth {

struct Point {
  double age, value;  // months
};

// The points' values on both sides of an age, and how far it is from the left one to the right one, 0 to 1.
struct Stretch {
  double left, right, share;
};

// Ages rise; beyond their ends the last value stays.
template <std::size_t kCount>
Stretch stretch_at(const Point (&points)[kCount], double age) {
  if (age <= points[0].age) return {points[0].value, points[0].value, 0};
  for (std::size_t i = 1; i < kCount; ++i) {
    const Point &left = points[i - 1], &right = points[i];
    if (age <= right.age) return {left.value, right.value, (age - left.age) / (right.age - left.age)};
  }
  return {points[kCount - 1].value, points[kCount - 1].value, 0};
}

// On straight lines through the points.
template <std::size_t kCount>
double on_lines(const Point (&points)[kCount], double age) {
  const Stretch at = stretch_at(points, age);
  return at.left + (at.right - at.left) * at.share;
}

}  // namespace mimo::growth
