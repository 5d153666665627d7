#include "growth/percentile.h"

#include <cmath>

#include "base/fail.h"
#include "growth/growth.h"

namespace mimo::growth {
namespace {

double percentile_of(double z) { return 50 * std::erfc(-z / std::sqrt(2.0)); }

}  // namespace

double z_of_percentile(double percentile) {
  // Below 1 most people mean a fraction, .5 for the median.
  const double most = percentile_of(kMostZ);
  require(percentile >= 1 && percentile <= most,
          "percentile is {}, expected percent, 1 to {:.3f}, of which 50 is the median; smaller infants have z_length, "
          "z_weight and z_head",
          percentile, most);
  if (percentile == 50) return 0;
  double low = -kMostZ, high = kMostZ;
  constexpr int kHalvings = 60;  // down to the last bit
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (percentile_of(middle) < percentile ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace mimo::growth
