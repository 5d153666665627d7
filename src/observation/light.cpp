#include "observation/light.h"

#include <algorithm>
#include <cmath>

namespace mimo::observation {
namespace {

// Both from 0 to 1.
double decoded(double code) { return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4); }

double encoded(double light) { return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055; }

}  // namespace

const Light& Light::get() {
  static const Light light;
  return light;
}

Light::Light() : light_(), levels_(kMost + 1) {
  for (std::size_t i = 0; i < light_.size(); ++i) {
    light_[i] = static_cast<float>(std::lround(kMost * decoded(static_cast<double>(i) / 255)));
  }
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    levels_[i] = static_cast<std::uint8_t>(std::lround(255 * encoded(static_cast<double>(i) / kMost)));
  }
}

}  // namespace mimo::observation
