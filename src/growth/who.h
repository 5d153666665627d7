// What infants of an age measure and weigh, after the WHO.
#pragma once

#include "growth/growth.h"

namespace mimo::growth {

enum class Measure { kLength, kWeight, kHead };  // cm, kg, cm (circumference)

// Of an infant that is z standard deviations from the median of its age, 0 to 24 months, and sex. Of the mean of the
// sexes: the mean of a girl's and a boy's that are z from their medians.
double who(Measure measure, Sex sex, double age, double z);

}  // namespace mimo::growth
