// Whether points span a space.
#pragma once

#include <array>
#include <vector>

namespace mimo::document {

// Whether all points lie in one plane, but for some ten roundings of their coordinates, which are floats.
bool is_flat(const std::vector<std::array<double, 3>>& points);

}  // namespace mimo::document
