#include "observation/eyesight.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "observation/gaussian.h"
#include "observation/light.h"

namespace mimo::observation {
namespace {

constexpr std::size_t kChannels = 3;
constexpr double kSharp = 0.02;  // pixels: less than this changes no byte
constexpr float kLuminance[] = {0.2126F, 0.7152F, 0.0722F};

std::vector<float> kernel_of(double sigma) { return sigma < kSharp ? std::vector<float>{1} : gaussian(sigma); }

}  // namespace

double Eyesight::sigma() const { return acuity > 0 ? std::sqrt(std::log(peak_contrast) / 2) / (kPi * acuity) : 0; }

EyeFilter::EyeFilter(std::size_t height, std::size_t width, double sigma, double chroma)
    : height_(height),
      values_(width * kChannels),
      chroma_(static_cast<float>(chroma)),
      kernel_(kernel_of(sigma)),
      reach_(kernel_.size() - 1),
      kept_(2 * reach_ + 1),
      rows_(kept_ * values_),
      column_(values_ + 2 * reach_ * kChannels),
      out_(values_) {}

// A row at a time, so that what is at work stays near: rows are written when no other needs them any more.
void EyeFilter::filter(std::uint8_t* rgb) {
  if (reach_ == 0 && chroma_ == 1) return;
  const Light& light = Light::get();
  for (std::size_t y = 0; y < std::min(reach_, height_); ++y) decode(rgb, y);
  for (std::size_t y = 0; y < height_; ++y) {
    if (y + reach_ < height_) decode(rgb, y + reach_);
    blur_columns(y);
    blur_row();
    if (chroma_ != 1) fade();
    std::transform(out_.begin(), out_.end(), rgb + y * values_, [&](float value) { return light.level(value); });
  }
}

void EyeFilter::decode(const std::uint8_t* rgb, std::size_t y) {
  const Light& light = Light::get();
  std::transform(rgb + y * values_, rgb + (y + 1) * values_, row(y),
                 [&](std::uint8_t level) { return light.of(level); });
}

void EyeFilter::blur_columns(std::size_t y) {
  float* sum = column_.data() + reach_ * kChannels;
  const float* middle = row(y);
  for (std::size_t i = 0; i < values_; ++i) sum[i] = kernel_[0] * middle[i];
  for (std::size_t k = 1; k <= reach_; ++k) {
    const float *above = row(y < k ? 0 : y - k), *below = row(std::min(y + k, height_ - 1));
    const float weight = kernel_[k];
    for (std::size_t i = 0; i < values_; ++i) sum[i] += weight * (above[i] + below[i]);
  }
  for (std::size_t i = 0; i < reach_ * kChannels; ++i) {
    column_[i] = sum[i % kChannels];
    sum[values_ + i] = sum[values_ - kChannels + i % kChannels];
  }
}

void EyeFilter::blur_row() {
  const float* middle = column_.data() + reach_ * kChannels;
  float* out = out_.data();
  for (std::size_t i = 0; i < values_; ++i) out[i] = kernel_[0] * middle[i];
  for (std::size_t k = 1; k <= reach_; ++k) {
    const float *left = middle - k * kChannels, *right = middle + k * kChannels;
    const float weight = kernel_[k];
    for (std::size_t i = 0; i < values_; ++i) out[i] += weight * (left[i] + right[i]);
  }
}

// Luminance stays, and so do greys.
void EyeFilter::fade() {
  for (std::size_t i = 0; i < values_; i += kChannels) {
    float* pixel = out_.data() + i;
    const float grey = kLuminance[0] * pixel[0] + kLuminance[1] * pixel[1] + kLuminance[2] * pixel[2];
    for (std::size_t c = 0; c < kChannels; ++c) pixel[c] = grey + chroma_ * (pixel[c] - grey);
  }
}

}  // namespace mimo::observation
