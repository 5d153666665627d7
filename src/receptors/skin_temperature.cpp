#include "receptors/skin_temperature.h"

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

Touching touching(double before, double other, double other_effusivity) {
  if (!(other_effusivity > 0)) return {before, 0, 0};
  const double together = kSkinEffusivity * other_effusivity / (kSkinEffusivity + other_effusivity);
  return {before, interface_temperature(before, other, other_effusivity) - before, kTouch / together};
}

}  // namespace mimo::receptors
