#include "observation/blur.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace mimo::observation {
namespace {

constexpr std::size_t kChannels = 3;

// `at` moved by `by` (back or forth), kept inside 0 .. count - 1.
std::size_t moved(std::size_t at, std::ptrdiff_t by, std::size_t count) {
  const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(at) + by;
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, static_cast<std::ptrdiff_t>(count) - 1));
}

// Adds `weight` times a row of bytes.
void add(const std::uint8_t* row, float weight, std::size_t count, float* sum) {
  for (std::size_t i = 0; i < count; ++i) sum[i] += weight * static_cast<float>(row[i]);
}

void blur_columns(const std::uint8_t* rgb, std::size_t height, std::size_t width, const std::vector<float>& kernel,
                  float* out) {
  const std::size_t row = width * kChannels;
  std::fill_n(out, height * row, 0.0F);
  for (std::size_t y = 0; y < height; ++y) {
    float* sum = out + y * row;
    add(rgb + y * row, kernel[0], row, sum);
    for (std::size_t k = 1; k < kernel.size(); ++k) {
      const auto far = static_cast<std::ptrdiff_t>(k);
      add(rgb + moved(y, -far, height) * row, kernel[k], row, sum);
      add(rgb + moved(y, far, height) * row, kernel[k], row, sum);
    }
  }
}

std::uint8_t level(float value) { return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F)); }

void blur_row(const float* in, std::size_t width, const std::vector<float>& kernel, std::uint8_t* out) {
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
      float sum = kernel[0] * in[x * kChannels + channel];
      for (std::size_t k = 1; k < kernel.size(); ++k) {
        const auto far = static_cast<std::ptrdiff_t>(k);
        sum += kernel[k] *
               (in[moved(x, -far, width) * kChannels + channel] + in[moved(x, far, width) * kChannels + channel]);
      }
      out[x * kChannels + channel] = level(sum);
    }
  }
}

}  // namespace

std::vector<float> blur_kernel(double cycles, double pixels_per_degree) {
  const double sigma = std::sqrt(std::log(2.0) / 2) / (kPi * cycles) * pixels_per_degree;  // pixels
  const auto reach = static_cast<std::size_t>(std::ceil(3 * sigma));
  std::vector<double> weights(reach + 1);
  double sum = 0;
  for (std::size_t k = 0; k <= reach; ++k) {
    const double far = static_cast<double>(k) / sigma;
    weights[k] = std::exp(-0.5 * far * far);
    sum += k == 0 ? weights[k] : 2 * weights[k];
  }
  std::vector<float> kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

void blur(std::uint8_t* rgb, std::size_t height, std::size_t width, const std::vector<float>& kernel,
          std::vector<float>& room) {
  blur_columns(rgb, height, width, kernel, room.data());
  const std::size_t row = width * kChannels;
  for (std::size_t y = 0; y < height; ++y) blur_row(room.data() + y * row, width, kernel, rgb + y * row);
}

}  // namespace mimo::observation
