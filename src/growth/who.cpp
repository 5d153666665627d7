#include "growth/who.h"

#include <cmath>
#include <numeric>

#include "base/fail.h"
#include "base/functions.h"
#include "growth/growth.h"

namespace mimo::growth {
namespace {

// One of a standard's three numbers at an age.
double at(const Monthly& values, double age) {
  Monthly months{};
  std::iota(months.begin(), months.end(), 0);
  return Curve(months, values)(age);
}

const LmsTable& table(Measure measure, Sex sex) {
  switch (measure) {
    case Measure::kLength: return sex == Sex::kMale ? kLengthMale : kLengthFemale;
    case Measure::kWeight: return sex == Sex::kMale ? kWeightMale : kWeightFemale;
    case Measure::kHead: break;
  }
  return sex == Sex::kMale ? kHeadMale : kHeadFemale;
}

double percentile_of(double z) { return 50 * fixed::erfc(-z / std::sqrt(2.0)); }

double median(Measure measure, double age) { return who(measure, Sex::kMean, age, 0); }

}  // namespace

double who(Measure measure, Sex sex, double age, double z) {
  if (sex == Sex::kMean) return (who(measure, Sex::kFemale, age, z) + who(measure, Sex::kMale, age, z)) / 2;
  const auto& [of_l, of_m, of_s] = table(measure, sex);
  const double l = at(of_l, age), m = at(of_m, age), s = at(of_s, age);
  // Cole and Green, Statistics in Medicine 11 (1992) 1305-1319.
  return l == 0 ? m * fixed::exp(s * z) : m * fixed::pow(1 + l * s * z, 1 / l);
}

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

Drivers drivers(const Growth& growth) {
  const auto weight_at = [&](double z) { return who(Measure::kWeight, growth.sex, growth.age, z); };
  Drivers it{};
  it.length = who(Measure::kLength, growth.sex, growth.age, growth.z_length);
  it.weight = weight_at(growth.z_weight);
  it.head = who(Measure::kHead, growth.sex, growth.age, growth.z_head);
  const double base_weight = median(Measure::kWeight, kBaseAge);
  const auto slenderness = [&](double weight) { return (weight / it.length) / (base_weight / length_at_18_months()); };
  it.l = it.length / length_at_18_months();
  it.w = slenderness(it.weight);
  it.h = it.head / median(Measure::kHead, kBaseAge);
  it.mass = it.weight / base_weight;
  it.frame = slenderness(weight_at(growth.z_length));
  return it;
}

double length_at_18_months() { return median(Measure::kLength, kBaseAge); }

double median_length_ratio(double age) { return median(Measure::kLength, age) / length_at_18_months(); }

}  // namespace mimo::growth
