// mimo_growth, from the caller's form to ours.
#pragma once

#include "growth/growth.h"
#include "mimo/growth.h"

namespace mimo::capi {

// Throws for what is out of range.
growth::Growth growth_from(const mimo_growth& config, const char* argument);

}  // namespace mimo::capi
