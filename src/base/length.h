// The length of what has these parts. Not std::hypot, whose last digit differs between releases of the C library, and
// with it pictures and senses; nothing here is so large or so small that its square is not a number.
#pragma once

#include <cmath>

namespace mimo {

template <typename Real>
Real length_of(Real x, Real y) {
  return std::sqrt(x * x + y * y);
}

template <typename Real>
Real length_of(Real x, Real y, Real z) {
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace mimo
