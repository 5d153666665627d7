#include "receptors/skin_temperature.h"

#include <cmath>

#include "receptors/materials.h"

namespace mimo::receptors {
namespace {

constexpr double kHeatCapacity = 3600;  // of a millimetre of skin, J/(m^2 K)
constexpr double kTouch = 350;          // W/(m^2 K)

}  // namespace

double resting_temperature(const Surroundings& around) {
  return (around.blood * around.core + around.loss * around.air) / (around.blood + around.loss);
}

double skin_kept(const Surroundings& around, double seconds) {
  return std::exp(-seconds * (around.blood + around.loss) / kHeatCapacity);
}

double interface_temperature(double skin, double other, double other_effusivity) {
  return (kSkinEffusivity * skin + other_effusivity * other) / (kSkinEffusivity + other_effusivity);
}

double touched_temperature(double before, double other, double other_effusivity, double seconds) {
  if (!(other_effusivity > 0)) return before;
  const double together = kSkinEffusivity * other_effusivity / (kSkinEffusivity + other_effusivity);
  const double x = kTouch * std::sqrt(seconds) / together;
  const double meeting = interface_temperature(before, other, other_effusivity);
  return before + (meeting - before) * (1 - scaled_erfc(x));
}

// Beyond 25 the exponential would overflow; the asymptotic series is exact to all digits there.
double scaled_erfc(double x) {
  if (x < 25) return std::exp(x * x) * std::erfc(x);
  const double square = 1 / (x * x);
  return (1 - square * (0.5 - 0.75 * square)) / (x * 1.7724538509055160);
}

}  // namespace mimo::receptors
