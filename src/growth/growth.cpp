#include "growth/growth.h"

#include <cmath>

#include "base/fail.h"
#include "common/ranges.h"
#include "growth/joints.h"
#include "growth/original/original.h"
#include "growth/sizes.h"

namespace mimo::growth {
namespace {

void check_range(double value, const ranges::Range<double>& range, const char* unit = "") {
  require_between(value, range.low, range.high, range.name, unit);
}

// The original knows nothing of these.
void check_original(const Growth& growth) {
  require(growth.sex == Sex::kMean, "sex is {}, expected 0: the original's model has no sexes",
          static_cast<int>(growth.sex));
  require(growth.physiological_age == growth.age,
          "physiological_age is {} and age {}, expected the same: the original's model has only one age",
          growth.physiological_age, growth.age);
  const auto check_median = [](const char* name, double z) {
    require(z == 0, "{} is {}, expected 0: the original's model has only the mean infant", name, z);
  };
  check_median("z_length", growth.z_length);
  check_median("z_weight", growth.z_weight);
  check_median("z_head", growth.z_head);
  require(!growth.absolute, "absolute is 1, expected 0: the original's model has lengths and masses of its own");
}

}  // namespace

void check(const Growth& growth) {
  namespace range = ranges::growth;
  check_range(growth.age, range::age, " months");
  check_range(growth.physiological_age, range::physiological_age, " months");
  check_range(growth.z_length, range::z_length, " standard deviations");
  check_range(growth.z_weight, range::z_weight, " standard deviations");
  check_range(growth.z_head, range::z_head, " standard deviations");
  check_range(growth.strength_exponent, range::strength_exponent);
  check_range(growth.neck_strength, range::neck_strength);
  check_range(growth.birth_tone, range::birth_tone);
  check_range(growth.contracture, range::contracture);
  if (growth.model == Model::kOriginal) check_original(growth);
}

Skeleton grown(const Skeleton& base, const Growth& growth) {
  check(growth);
  if (growth.model == Model::kOriginal) return grown_as_original(base, growth.age);
  Skeleton body = fit(base, growth).skeleton;
  strengthen(body, base, growth);
  spread_mass(body, growth.age);
  limit(body, growth);
  set_tone(body, base, growth);
  return body;
}

}  // namespace mimo::growth
