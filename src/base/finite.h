// check_finite(values, count, "action"): refuses numbers that are not finite.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/fail.h"

namespace mimo {

inline void check_finite(const double* values, std::size_t count, const char* argument) {
  for (std::size_t i = 0; i < count; ++i) {
    require(std::isfinite(values[i]), "{}[{}] is {}, expected a finite number", argument, i, values[i]);
  }
}

}  // namespace mimo
