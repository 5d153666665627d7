// What a body measures.
#pragma once

#include "growth/skeleton.h"

namespace mimo::growth {

// From the soles to the top of the head, standing straight: where all joints are at 0.
double stature(const Skeleton& skeleton);

}  // namespace mimo::growth
