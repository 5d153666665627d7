// mimo_growth, from the caller's form to ours.
#pragma once

#include "blueprint/worlds_by_age.h"
#include "growth/growth.h"
#include "mimo/growth.h"

namespace mimo::capi {

// Throws for what is out of range.
growth::Growth growth_from(const mimo_growth& config, const char* argument);
// Of an array whose entries may be NULL: these stay.
blueprint::Ages ages_from(const mimo_growth* const* growth, std::size_t count, const char* argument);

}  // namespace mimo::capi
