// Blurred pictures: what is left for an eye that tells apart fewer lines a degree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mimo::observation {

// Half of a Gaussian, from its middle outwards, normalised as a whole: of `cycles` per degree half the contrast is
// left.
std::vector<float> blur_kernel(double cycles, double pixels_per_degree);

// Blurs height x width x 3 bytes in place; beyond its edges a picture goes on as it is there. `room` holds as many
// floats.
void blur(std::uint8_t* rgb, std::size_t height, std::size_t width, const std::vector<float>& kernel,
          std::vector<float>& room);

}  // namespace mimo::observation
