// How far the joints of an infant go: newborns cannot stretch hips, knees and elbows.
#pragma once

#include "growth/growth.h"
#include "growth/skeleton.h"

namespace mimo::growth {

// Sets limits, and where the springs of hips, knees and elbows pull to, of a body that has the base's.
void limit(Skeleton& body, const Growth& growth);

}  // namespace mimo::growth
