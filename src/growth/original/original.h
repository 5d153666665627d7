// The rules by which MIMo v2 makes a body of another age, for those who compare. They keep what is wrong with them:
// neither at 18 months nor in proportion do they give the body that they start from, and joints and muscles' peak
// forces stay as they are.
#pragma once

#include "growth/skeleton.h"

namespace mimo::growth {

// At an age from 0 to 24 months.
Skeleton grown_as_original(const Skeleton& base, double age);

}  // namespace mimo::growth
