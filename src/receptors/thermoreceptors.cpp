#include "receptors/thermoreceptors.h"

#include <algorithm>
#include <cmath>

namespace mimo::receptors {
namespace {

double bell(double x) { return std::exp(-x * x); }

}  // namespace

double cold_rate(double temperature, double change) {
  return std::max(0.0, 8 * bell((temperature - 30) / 6) - 20 * change);
}

double warm_rate(double temperature, double change) {
  return std::max(0.0, 12 * bell((temperature - 41) / 5) + 10 * change);
}

}  // namespace mimo::receptors
