#include "observation/gaussian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/angle.h"

namespace mimo::observation {
namespace {

constexpr double kFitted = 1.1;    // pixels: wider Gaussians can be sampled
constexpr double kReach = 3.5;     // sampled up to so many sigma
constexpr double kWidest = 140;    // pixels: little is left of any picture
constexpr std::size_t kSides = 3;  // fitted weights beside the middle

// A number that the last bit of a library's exp or cos cannot change. Twice as much in whole 65536ths is what a row is
// weighed with.
double rounded(double weight) { return std::round(weight * 131072) / 131072; }

// Samples of a narrow Gaussian leave far too much (0.3 too much at 0.3 pixels). These weights are those of least
// squares over all frequencies that pixels can hold. The sum is to be 1, so they are fitted to what is lost: each takes
// away 2 - 2 cos(2 pi k f). Low frequencies, which rendered pictures have most of, weigh more.
class Fit {
 public:
  explicit Fit(double sigma) {
    for (std::size_t i = 0; i < kSteps; ++i) add((static_cast<double>(i) + 0.5) / (2 * kSteps), sigma);
  }

  // One weight after the other, until none changes.
  std::vector<double> weights() const {
    std::vector<double> weights(kSides);
    for (int sweep = 0; sweep < 300; ++sweep) {
      for (std::size_t k = 0; k < kSides; ++k) {
        double rest = lost_[k];
        for (std::size_t l = 0; l < kSides; ++l) rest -= l == k ? 0 : products_[k][l] * weights[l];
        weights[k] = rest / products_[k][k];
      }
    }
    return weights;
  }

 private:
  void add(double frequency, double sigma) {
    const double weight = std::pow(std::cos(kPi * frequency), 2);
    const double lost = 1 - std::exp(-2 * std::pow(kPi * sigma * frequency, 2));
    std::array<double, kSides> by{};
    for (std::size_t k = 0; k < kSides; ++k) by[k] = 2 - 2 * std::cos(2 * kPi * static_cast<double>(k + 1) * frequency);
    for (std::size_t k = 0; k < kSides; ++k) {
      lost_[k] += weight * by[k] * lost;
      for (std::size_t l = 0; l < kSides; ++l) products_[k][l] += weight * by[k] * by[l];
    }
  }

  static constexpr std::size_t kSteps = 200;
  std::array<double, kSides> lost_{};
  std::array<std::array<double, kSides>, kSides> products_{};
};

std::vector<double> sampled(double sigma) {
  std::vector<double> weights(static_cast<std::size_t>(std::ceil(kReach * sigma)));
  double sum = 1;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double far = static_cast<double>(k + 1) / sigma;
    weights[k] = std::exp(-0.5 * far * far);
    sum += 2 * weights[k];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace

// Rounded from the far end on, so that what rounding leaves goes to the next weight and not all to the middle.
std::vector<float> gaussian_kernel(double sigma) {
  const double width = std::min(sigma, kWidest);
  const std::vector<double> sides = width > kFitted ? sampled(width) : Fit(width).weights();
  std::vector<float> kernel(sides.size() + 1);
  double sum = 0, given = 0;
  for (std::size_t k = sides.size(); k > 0; --k) {
    sum += sides[k - 1];
    const double weight = rounded(sum - given);
    kernel[k] = static_cast<float>(weight);
    given += weight;
  }
  kernel[0] = static_cast<float>(1 - 2 * given);
  while (kernel.size() > 1 && kernel.back() == 0) kernel.pop_back();
  return kernel;
}

}  // namespace mimo::observation
