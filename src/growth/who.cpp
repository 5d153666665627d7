#include "growth/who.h"

#include <cmath>
#include <numeric>

#include "growth/curve.h"
#include "growth/who_tables.h"

namespace mimo::growth {
namespace {

Curve monthly(const Monthly& values) {
  std::vector<double> months(values.size());
  std::iota(months.begin(), months.end(), 0);
  return {months, {values.begin(), values.end()}};
}

// A standard: the three numbers by age.
class Standard {
 public:
  explicit Standard(const LmsTable& table) : l_(monthly(table[0])), m_(monthly(table[1])), s_(monthly(table[2])) {}

  // Cole and Green, Statistics in Medicine 11 (1992) 1305-1319.
  double operator()(double age, double z) const {
    const double l = l_(age), m = m_(age), s = s_(age);
    return l == 0 ? m * std::exp(s * z) : m * std::pow(1 + l * s * z, 1 / l);
  }

 private:
  Curve l_, m_, s_;
};

const Standard& standard(Measure measure, Sex sex) {
  static const Standard length[] = {Standard(kLengthFemale), Standard(kLengthMale)};
  static const Standard weight[] = {Standard(kWeightFemale), Standard(kWeightMale)};
  static const Standard head[] = {Standard(kHeadFemale), Standard(kHeadMale)};
  const int column = sex == Sex::kMale ? 1 : 0;
  switch (measure) {
    case Measure::kLength: return length[column];
    case Measure::kWeight: return weight[column];
    case Measure::kHead: break;
  }
  return head[column];
}

}  // namespace

double who(Measure measure, Sex sex, double age, double z) {
  if (sex != Sex::kMean) return standard(measure, sex)(age, z);
  return (who(measure, Sex::kFemale, age, z) + who(measure, Sex::kMale, age, z)) / 2;
}

}  // namespace mimo::growth
