#include "growth/growth.h"

#include <cmath>

#include "base/fail.h"
#include "growth/joints.h"
#include "growth/original/original.h"
#include "growth/sizes.h"

namespace mimo::growth {
namespace {

void check_range(const char* name, double value, double least, double most, const char* unit) {
  require(value >= least && value <= most, "{} is {}, expected {} to {}{}", name, value, least, most, unit);  // or NaN
}

void check_z(const char* name, double z) { check_range(name, z, -kMostZ, kMostZ, " standard deviations"); }

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
  check_range("age", growth.age, 0, kOldest, " months");
  check_range("physiological_age", growth.physiological_age, 0, kOldest, " months");
  check_z("z_length", growth.z_length);
  check_z("z_weight", growth.z_weight);
  check_z("z_head", growth.z_head);
  check_range("strength_exponent", growth.strength_exponent, 0, 5, "");
  check_range("neck_strength", growth.neck_strength, 0, 10, "");
  check_range("birth_tone", growth.birth_tone, 0.1, 10, "");
  check_range("contracture", growth.contracture, 0, 1, "");
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
