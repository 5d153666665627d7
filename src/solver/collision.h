// Contacts, by MuJoCo's own functions for two shapes. Which pairs are asked about is decided here.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// A quick look at two shapes before MuJoCo's thorough one.

// True only if a plane parts two shapes by more than the margin, so that there is no contact to be found. Not all such
// pairs are told: looked at are the few planes that part most neighbours, and pairs that are not found out about as
// quickly otherwise.
bool are_apart(const mjModel& model, const mjData& data, int geom, int other, double margin);

// What happens between two shapes.

// Adds the contacts of two shapes that are not of one body, by the rules that follow from what the two say.
void collide_shapes(const mjModel& model, mjData& data, int geom, int other);

// The same for a pair that the model lists, by its rules.
void collide_pair(const mjModel& model, mjData& data, int pair);

// Contacts, by MuJoCo's own functions for two shapes. What is ours is which shapes are asked about: nothing is sorted
// and nothing allocated, and shapes that a plane parts are not asked about at all (docs/adr/0017-collisions.md).

// As mj_collision, with the same contacts in the same order. Takes its room from mjData's stack. MuJoCo 4 searches by
// itself: it has other shapes and a better search.
void collide(const mjModel& model, mjData& data);

}  // namespace mimo::solver
