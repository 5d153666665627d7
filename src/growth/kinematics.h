// Where the parts of a body are in a pose.
#pragma once

#include <map>
#include <string>

#include "growth/skeleton.h"

namespace mimo::growth {

// Height of the lowest point of all geoms, in the frame that the first bone stands in; joints that are not named are at 0.
double lowest_point(const Skeleton& skeleton, const std::map<std::string, double>& angles);

}  // namespace mimo::growth
