// How an infant's mass is spread over its parts.
#pragma once

#include "growth/skeleton.h"

namespace mimo::growth {

// Changes masses of a body that has one density per part at all ages, and leaves their sum. Torques and muscles' peak
// forces change along, so that a joint stays as strong over the weight that it carries. Throws
// Status::kInvalidArgument where nothing would be left for the trunk.
void spread_mass(Skeleton& body, double age);

}  // namespace mimo::growth
