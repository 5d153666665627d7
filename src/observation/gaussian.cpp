#include "observation/gaussian.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/angle.h"

namespace mimo::observation {
namespace {

double left_of(double sigma, double frequency) {
  const double turn = kPi * sigma * frequency;
  return std::exp(-2 * turn * turn);
}

// The k-th Fourier coefficient of what is left, over all frequencies that pictures have, by Simpson's rule. The first
// few of them are the numbers that come nearest to it, in the sense of least squares.
double coefficient(double sigma, std::size_t k) {
  constexpr int kParts = 512;
  double sum = 0;
  for (int i = 0; i <= kParts; ++i) {
    const double frequency = 0.5 * i / kParts;
    const double weight = i == 0 || i == kParts ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * left_of(sigma, frequency) * std::cos(2 * kPi * static_cast<double>(k) * frequency);
  }
  return sum / (3.0 * kParts);
}

}  // namespace

std::vector<float> gaussian(double sigma) {
  constexpr double kLeast = 3, kSigmas = 4;  // pixels to each side, and deviations
  const auto reach = static_cast<std::size_t>(std::max(kLeast, std::ceil(kSigmas * sigma)));
  std::vector<double> weights;
  double sum = 0;
  for (std::size_t k = 0; k <= reach; ++k) {
    weights.push_back(coefficient(sigma, k));
    sum += k == 0 ? weights[k] : 2 * weights[k];
  }
  std::vector<float> kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

}  // namespace mimo::observation
