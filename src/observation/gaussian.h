// The Gaussian that pictures are blurred with.
#pragma once

#include <vector>

namespace mimo::observation {

// Half of the kernel, from its middle outwards, for a Gaussian of `sigma` pixels; the whole kernel's sum is exactly 1.
// What it leaves of a grating of f cycles per pixel follows exp(-2 pi^2 sigma^2 f^2): up to f = 0.4 within 0.006; at f
// = 0.5 it leaves up to 0.08 more. Below 0.7 pixels no weights above 0 can do that: those 2 pixels away are down to
// -0.015 then, and the smoother sees to it that no edge gets a ring.
std::vector<float> gaussian_kernel(double sigma);

}  // namespace mimo::observation
