// Makes the body of 18 months one of another age.
#pragma once

#include "growth/growth.h"
#include "growth/skeleton.h"

namespace mimo::growth {

// By the WHO's model the body at 18 months, mean of the sexes, median in everything, is the base itself, to the last
// bit. Nothing but numbers differs: bones, geoms, joints, marks and motors stay in their order. Throws
// Status::kInvalidArgument for a combination that no infant can have, and Status::kUnsupported for a body that is none
// of ours.
Skeleton grown(const Skeleton& base, const Growth& growth);

}  // namespace mimo::growth
