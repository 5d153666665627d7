// How hard a motor can pull.
#pragma once

#include <utility>

typedef struct mjModel_ mjModel;

namespace mimo::body {

// The range of a motor's force, before its gear; what has none pulls as hard as its controls may tell it, 0 and 0 where
// they may be anything.
std::pair<double, double> forces_of(const mjModel& model, int motor);

}  // namespace mimo::body
