// The WHO's child growth standards by month, from birth to 24 months: for each sex and measure the numbers L, M and S
// of which a value is made. Lengths are those of lying infants.
//
// WHO Multicentre Growth Reference Study Group: WHO Child Growth Standards. World Health Organization, 2006 (length,
// weight) and 2007 (head circumference).
#pragma once

#include <array>

namespace mimo::growth {

using Monthly = std::array<double, 25>;
using LmsTable = std::array<Monthly, 3>;  // L, M, S

extern const LmsTable kLengthFemale, kLengthMale;  // M in cm
extern const LmsTable kWeightFemale, kWeightMale;  // M in kg
extern const LmsTable kHeadFemale, kHeadMale;      // M in cm

}  // namespace mimo::growth
