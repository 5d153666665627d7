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

double withdrawal_force(double months) { return 0.0118 * std::pow(45.1 / 11.8, std::clamp(months, 0.0, 12.0) / 12); }

}  // namespace mimo::receptors
