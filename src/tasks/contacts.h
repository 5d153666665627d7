// Who touches whom, by the contacts that the last physics step found.
#pragma once

#include <vector>

#include "engine/physics.h"

namespace mimo::tasks {

// Whether any of the bodies touches the other one.
bool touches(const engine::Physics& physics, const std::vector<int>& bodies, int other);

// Whether a contact presses on the body, however weakly: what its skin would feel.
bool feels(const engine::Physics& physics, int body);

}  // namespace mimo::tasks
