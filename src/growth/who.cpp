#include "growth/who.h"

#include <cmath>
#include <numeric>

#include "growth/curve.h"
#include "growth/who_tables.h"

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

}  // namespace

double who(Measure measure, Sex sex, double age, double z) {
  if (sex == Sex::kMean) return (who(measure, Sex::kFemale, age, z) + who(measure, Sex::kMale, age, z)) / 2;
  const auto& [of_l, of_m, of_s] = table(measure, sex);
  const double l = at(of_l, age), m = at(of_m, age), s = at(of_s, age);
  // Cole and Green, Statistics in Medicine 11 (1992) 1305-1319.
  return l == 0 ? m * std::exp(s * z) : m * std::pow(1 + l * s * z, 1 / l);
}

}  // namespace mimo::growth
