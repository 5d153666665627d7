// Sizes, places and masses of a body's parts, by factors.
#pragma once

#include "growth/proportions.h"
#include "growth/skeleton.h"

namespace mimo::growth {

// Density stays: a mass goes with its volume. Throws Status::kUnsupported for a body or a geom of the trunk that is
// none of ours.
Skeleton resized(const Skeleton& base, const Lengths& lengths, const Girths& girths);

}  // namespace mimo::growth
