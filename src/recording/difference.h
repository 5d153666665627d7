// How far two rows of numbers are apart.
#pragma once

#include "base/span.h"
#include "observation/field.h"

namespace mimo::recording {

// Of any number, 0 where all are the same to the last bit; numbers that are not finite count as the largest double.
double largest_difference(observation::Type type, Span<const std::uint8_t> one, Span<const std::uint8_t> other);

}  // namespace mimo::recording
