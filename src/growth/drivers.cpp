#include "growth/drivers.h"

#include "growth/who.h"

namespace mimo::growth {
namespace {

double median(Measure measure, double age) { return who(measure, Sex::kMean, age, 0); }

}  // namespace

Drivers drivers(const Growth& growth) {
  const auto weight_at = [&](double z) { return who(Measure::kWeight, growth.sex, growth.age, z); };
  Drivers it{};
  it.length = who(Measure::kLength, growth.sex, growth.age, growth.z_length);
  it.weight = weight_at(growth.z_weight);
  it.head = who(Measure::kHead, growth.sex, growth.age, growth.z_head);
  const double base_weight = median(Measure::kWeight, kBase);
  const auto slenderness = [&](double weight) { return (weight / it.length) / (base_weight / length_at_18_months()); };
  it.l = it.length / length_at_18_months();
  it.w = slenderness(it.weight);
  it.h = it.head / median(Measure::kHead, kBase);
  it.mass = it.weight / base_weight;
  it.frame = slenderness(weight_at(growth.z_length));
  return it;
}

double length_at_18_months() { return median(Measure::kLength, kBase); }

double median_length_ratio(double age) { return median(Measure::kLength, age) / length_at_18_months(); }

}  // namespace mimo::growth
