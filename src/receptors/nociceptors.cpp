#include "receptors/nociceptors.h"

#include <algorithm>
#include <cmath>

namespace mimo::receptors {
namespace {

constexpr double kSoftness = 0.2e6;  // Pa
constexpr double kPi = 3.14159265358979323846;

}  // namespace

double contact_pressure(double force, double radius) {
  if (!(force > 0) || !(radius > 0)) return 0;
  const double patch = std::cbrt(3 * force * radius / (4 * kSoftness));
  return force / (kPi * patch * patch);
}

double fast_pressure_rate(double over, double adapted) { return 20 * std::max(0.0, over - 1) * (1 - 0.6 * adapted); }

double slow_pressure_rate(double over) { return 5 * std::max(0.0, over - 0.8); }

double fast_heat_rate(double temperature) { return 5 * std::max(0.0, temperature - 46); }

double slow_heat_rate(double temperature) {
  return 2 * std::max(0.0, temperature - 43) + std::max(0.0, 18 - temperature);
}

double withdrawal_force(double months) { return 0.0118 * std::pow(45.1 / 11.8, std::clamp(months, 0.0, 12.0) / 12); }

}  // namespace mimo::receptors
