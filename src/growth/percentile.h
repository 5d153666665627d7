// Percentiles of a normal distribution, as parents know them from growth charts.
#pragma once

namespace mimo::growth {

// Standard deviations from the median. Throws Status::kInvalidArgument for a percentile that is further away than
// kMostZ.
double z_of_percentile(double percentile);

}  // namespace mimo::growth
