// What configs of eyes, of other cameras and of pictures have in common.
#pragma once

#include <cstdint>

#include "base/header.h"
#include "capi/check.h"
#include "mimo/experimental.h"
#include "senses/vision.h"

namespace mimo::capi {

constexpr std::uint32_t kLargestPicture = 4096;

// An entry of a config, with the name that messages give it.
template <typename T>
struct Entry {
  const char* name;
  T value;
};

inline void check_view(Entry<std::uint32_t> width, Entry<std::uint32_t> height, Entry<double> fovy) {
  for (const Entry<std::uint32_t>& size : {width, height}) {
    require_between(size.value, 1U, kLargestPicture, size.name);
  }
  require(fovy.value == 0 || (fovy.value >= 1 && fovy.value <= 170),
          "{} is {}, expected 1 to 170 degrees, or 0 for the camera's own", fovy.name, fovy.value);
}

inline double foveation(double strength, const char* name) {
  require(strength == 0 || (strength >= 0.01 && strength <= 100), "{} is {}, expected 0.01 to 100, or 0 for none", name,
          strength);
  return strength;
}

inline senses::VisionOptions vision(Entry<std::uint32_t> outputs, Entry<std::uint32_t> width,
                                    Entry<std::uint32_t> height, Entry<double> fovy) {
  check_bits(outputs.value, header::kVision, outputs.name);
  senses::VisionOptions options;
  options.wanted = outputs.value;
  if (options.wanted == 0) return options;
  check_view(width, height, fovy);
  options.width = static_cast<int>(width.value);
  options.height = static_cast<int>(height.value);
  options.fovy = fovy.value;
  return options;
}

}  // namespace mimo::capi
