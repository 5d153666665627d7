// What kinds of joints there are in a compiled model.
#pragma once

#include "engine/model.h"

namespace mimo::engine {

// A hinge or a slide, whose position is one number.
bool has_one_axis(const mjModel& model, int joint);

// Where the position of a body with a free joint starts in qpos. Throws Status::kModel for a body without.
int free_joint_address(const mjModel& model, int body);

}  // namespace mimo::engine
