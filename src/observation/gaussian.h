// A Gaussian for pictures.
#pragma once

#include <vector>

namespace mimo::observation {

// Half of it, from its middle outwards, with a sum of one as a whole; `sigma` is in pixels. What it leaves of the
// contrast of f cycles per pixel is exp(-2 (pi sigma f)^2), as near as so many numbers allow, below one pixel as well:
// a sampled bell would leave up to a third too much there.
std::vector<float> gaussian(double sigma);

}  // namespace mimo::observation
