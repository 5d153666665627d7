// Joints that are held at an angle in one world.
#pragma once

#include "env/world.h"

namespace mimo::env {

// What a joint's lock does.
struct Lock {
  bool locked;
  double angle;  // at which it holds the joint, or would hold it, radians
};

// All throw Status::kUnsupported for a joint without a lock.
Lock lock_state(const World& world, int joint);
// Both throw also for a joint under position control, whose lock follows the actions.
void lock(World& world, int joint, double angle);
void unlock(World& world, int joint);

}  // namespace mimo::env
