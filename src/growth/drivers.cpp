#include "growth/drivers.h"

#include "growth/who.h"

namespace mimo::growth {
namespace {

constexpr double kBase = 18;  // months

double median(Measure measure, double age) { return who(measure, Sex::kMean, age, 0); }

}  // namespace

Drivers drivers(const Growth& growth) {
  const double length = who(Measure::kLength, growth.sex, growth.age, growth.z_length);
  const double weight = who(Measure::kWeight, growth.sex, growth.age, growth.z_weight);
  const double head = who(Measure::kHead, growth.sex, growth.age, growth.z_head);
  const double base_weight = median(Measure::kWeight, kBase);
  return {length,
          weight,
          head,
          length / length_at_18_months(),
          (weight / length) / (base_weight / length_at_18_months()),
          head / median(Measure::kHead, kBase),
          weight / base_weight};
}

double length_at_18_months() { return median(Measure::kLength, kBase); }

double median_length_ratio(double age) { return median(Measure::kLength, age) / length_at_18_months(); }

}  // namespace mimo::growth
