#include "reflexes/table.h"

#include <algorithm>

#include "base/functions.h"
#include "base/header.h"
#include "base/numbers.h"

namespace mimo::reflexes {
namespace {

constexpr double kWeek = 7 / 30.4375;  // months
// Months from birth at term, of weeks from conception.
constexpr double weeks(double since_conception) { return (since_conception - 40) * kWeek; }

// In the order of Reflex.
constexpr Rule kRules[kReflexes] = {
    {MIMO_REFLEX_PALMAR_GRASP, "palmar_grasp", weeks(25), 4, kSpinal, 0.1, 0.5, "N", true, 0.3, 0.3, 0.5},
    {MIMO_REFLEX_PLANTAR_GRASP, "plantar_grasp", weeks(25), 9, kSpinal, 0.1, 0.5, "N", true, 0.3, 0.3, 0.4},
    {MIMO_REFLEX_ROOTING, "rooting", weeks(28), 4, kBrainStem, 0.02, 0.5, "N", false, 0.6, 0.4, 0.4},
    {MIMO_REFLEX_MORO, "moro", weeks(30), 5, kBrainStem, 1, 0.5, "", false, 1.1, 0.4, 0.4},
    {MIMO_REFLEX_ASYMMETRIC_TONIC_NECK, "asymmetric_tonic_neck", 0, 6, kBrainStem, 45, 2.0 / 3, "degrees", true, 0.3,
     0.5, 0.3},
    {MIMO_REFLEX_STEPPING, "stepping", weeks(38), 2, kSpinal, 1, 0.5, "", true, 0.3, 0.2, 0.4},
    {MIMO_REFLEX_WITHDRAWAL, "withdrawal", weeks(25), kNever, kSpinal, 1, 0.5, "", false, 0.5, 0.5, 0.4},
};

constexpr bool rules_are_in_order() {
  for (std::size_t i = 0; i < kReflexes; ++i) {
    if (kRules[i].bit != 1U << i) return false;
  }
  return bits_of(kRules) == (header::kReflex & ~MIMO_REFLEX_FELT);
}
static_assert(rules_are_in_order(), "a reflex of the header has no rule, or one that is not in its place");

}  // namespace

const Rule& rule(Reflex reflex) { return kRules[static_cast<std::size_t>(reflex)]; }

double gain(const Rule& rule, double months) {
  if (months < rule.start) return 0;
  return std::clamp(rule.end - months, 0.0, 1.0);
}

double latency(const Rule& rule, const growth::Conduction& nerves, double sensory, double motor) {
  return nerves.along(sensory) + rule.centre + nerves.along(motor);
}

double withdrawal_force(double months) {
  constexpr double kBirth = 0.0118, kYear = 0.0451;  // N
  return kBirth * fixed::pow(kYear / kBirth, std::clamp(months / 12, 0.0, 1.0));
}

double crossed(double months) { return std::clamp((3 - months) / 2, 0.0, 1.0); }

}  // namespace mimo::reflexes
