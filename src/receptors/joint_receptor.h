// Joint receptors: they fire near the ends of a joint's range and hardly between. Rates and adaptation are an estimate.
#pragma once

#include <algorithm>

namespace mimo::receptors {

// `nearness` to this end: 0 where the joint is more than the threshold inside, 1 at the limit; `closing` is how fast it
// grows, 1/s. Hz.
inline double joint_receptor(double nearness, double closing) {
  constexpr double kLargest = 100, kAdapts = 0.1, kMost = 200;  // Hz, s, Hz
  if (nearness <= 0) return 0;
  return std::min(kMost, kLargest * (std::min(1.0, nearness) + kAdapts * std::max(0.0, closing)));
}

}  // namespace mimo::receptors
