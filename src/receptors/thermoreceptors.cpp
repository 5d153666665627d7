#include "receptors/thermoreceptors.h"

#include <algorithm>
#include <cmath>

namespace mimo::receptors {
namespace {

// Many of these are worked out for each look; seven digits are enough.
double bell(double x) { return static_cast<double>(std::exp(static_cast<float>(-x * x))); }

}  // namespace

double cold_rate(double temperature, double change) {
  return std::max(0.0, 8 * bell((temperature - 30) / 6) - 20 * change);
}

double warm_rate(double temperature, double change) {
  return std::max(0.0, 12 * bell((temperature - 41) / 5) + 10 * change);
}

}  // namespace mimo::receptors
