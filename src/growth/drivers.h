// What drives growth: length, slenderness and head, over those of the 18-month body.
#pragma once

#include "growth/growth.h"

namespace mimo::growth {

constexpr double kBase = 18;  // months: the age of the body that others grow from

struct Drivers {
  double length;  // cm, as the WHO's
  double weight;  // kg
  double head;    // circumference, cm
  // Over the same of 18 months, mean of the sexes, median.
  double l;
  double w;  // of weight over length
  double h;
  double mass;  // of weight
  double
      frame;  // w of an infant whose weight is as far from the median as its length: of bones, which fat leaves alone
};

Drivers drivers(const Growth& growth);

// Of the median there, cm.
double length_at_18_months();
// Median length at an age over that at 18 months.
double median_length_ratio(double age);

}  // namespace mimo::growth
