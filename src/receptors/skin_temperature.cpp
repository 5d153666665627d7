#include "receptors/skin_temperature.h"

#include <cmath>

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

// The rational fit of Numerical Recipes (erfcc) without its factor exp(-x^2): right to 1.2e-7 everywhere, and no
// overflow.
double scaled_erfc(double x) {
  constexpr double kFit[] = {-1.26551223, 1.00002368,  0.37409196, 0.09678418,  -0.18628806,
                             0.27886807,  -1.13520398, 1.48851587, -0.82215223, 0.17087277};
  const double t = 1 / (1 + 0.5 * x);
  double sum = 0;
  for (int i = 9; i >= 0; --i) sum = kFit[i] + t * sum;
  return t * std::exp(sum);
}

}  // namespace mimo::receptors
