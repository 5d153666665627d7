#include "reflexes/table.h"

#include <algorithm>
#include <cmath>

namespace mimo::reflexes {
namespace {

constexpr double kWeek = 7 / 30.4375;  // months
// Months from birth at term, of weeks from conception.
constexpr double weeks(double since_conception) { return (since_conception - 40) * kWeek; }

// In the order of Reflex.
constexpr Rule kRules[kReflexes] = {
    {"palmar_grasp", weeks(25), 4, kSpinal, 0.1, 0.5, "N", true, 0.3, 0.3, 0.5},
    {"plantar_grasp", weeks(25), 9, kSpinal, 0.1, 0.5, "N", true, 0.3, 0.3, 0.4},
    {"rooting", weeks(28), 4, kBrainStem, 0.02, 0.5, "N", false, 0.6, 0.4, 0.4},
    {"moro", weeks(30), 5, kBrainStem, 1, 0.5, "", false, 1.1, 0.4, 0.4},
    {"asymmetric_tonic_neck", 0, 6, kBrainStem, 45, 2.0 / 3, "degrees", true, 0.3, 0.5, 0.3},
    {"stepping", weeks(38), 2, kSpinal, 1, 0.5, "", true, 0.3, 0.2, 0.4},
    {"withdrawal", weeks(25), kNever, kSpinal, 1, 0.5, "", false, 0.5, 0.5, 0.4},
};

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
  return kBirth * std::pow(kYear / kBirth, std::clamp(months / 12, 0.0, 1.0));
}

double crossed(double months) { return std::clamp((3 - months) / 2, 0.0, 1.0); }

}  // namespace mimo::reflexes
