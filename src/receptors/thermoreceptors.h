// Cold and warm receptors: how warm skin is where they sit, and how that changes.
//
// Static rates follow fibres of monkeys (Hensel and Iggo 1971): cold ones fire most at 30 degrees, warm ones at 41. The
// curves' widths and the answers to change are estimates; infants are not known.
#pragma once

#include <Eigen/Core>

namespace mimo::receptors {

// How fast they follow the surface: cold receptors lie 0.15 mm deep, warm ones 0.3 mm. s.
constexpr double kColdLag = 0.36, kWarmLag = 1.44;

// Many are worked out for each look, so that they come in eights; seven digits are enough.
using Eight = Eigen::Array<float, 8, 1>;

// Temperature at the receptors, and its change in degrees a second. Hz.
Eight cold_rates(const Eight& temperature, const Eight& change);
Eight warm_rates(const Eight& temperature, const Eight& change);

}  // namespace mimo::receptors
