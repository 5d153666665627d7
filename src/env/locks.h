// Joints that are held at an angle in one world.
#pragma once

#include "env/world.h"

namespace mimo::env {

// The lock of a joint. Throws Status::kUnsupported for a joint without one.
int lock_of(const mjModel& model, int joint);

// Both throw also for a joint under position control, whose lock follows the actions.
void lock(World& world, int joint, double angle);
void unlock(World& world, int joint);

}  // namespace mimo::env
