// Bytes of pictures, and the light that they stand for: sRGB (IEC 61966-2-1).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace mimo::observation {

class Light {
 public:
  static constexpr int kMost = 65535;  // light of the byte 255

  static const Light& get();
  float of(std::uint8_t level) const { return light_[level]; }
  // The nearest level to light of 0 to kMost; what lies outside is cut.
  std::uint8_t level(float light) const {
    const float cut = light < 0 ? 0 : (light > kMost ? kMost : light);
    return levels_[static_cast<std::size_t>(static_cast<int>(cut + 0.5F))];
  }

 private:
  Light();
  std::array<float, 256> light_;  // whole numbers, so that they are the same wherever they are worked out
  std::vector<std::uint8_t> levels_;
};

}  // namespace mimo::observation
