// The light of many pixels at once, on processors with registers that hold a whole table.
#pragma once

#include <cstddef>
#include <cstdint>

#include "observation/contrast.h"

namespace mimo::observation {

// Both look at a row of red, green and blue bytes, and return how many of its pixels they have done: all but fewer than
// 32 with AVX-512, else none.

// The light of each byte.
std::size_t look_up_many(const std::uint8_t* rgb, std::size_t width, const LightTable& table, Light* red, Light* green,
                         Light* blue);
// The sum of the light of a pixel's three bytes.
std::size_t add_up_many(const std::uint8_t* rgb, std::size_t width, const LightTable& red, const LightTable& green,
                        const LightTable& blue, Light* sum);

}  // namespace mimo::observation
