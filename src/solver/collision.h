// Contacts, by MuJoCo's own functions for two shapes. What is ours is which shapes are asked about: nothing is sorted
// and nothing allocated, and shapes that a plane parts are not asked about at all (docs/adr/0017-collisions.md).
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// As mj_collision, with the same contacts in the same order. Takes its room from mjData's stack. MuJoCo 4 searches by
// itself: it has other shapes and a better search.
void collide(const mjModel& model, mjData& data);

}  // namespace mimo::solver
