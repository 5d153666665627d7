// What happens between two shapes.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// Adds the contacts of two shapes that are not of one body, by the rules that follow from what the two say.
void collide_shapes(const mjModel& model, mjData& data, int geom, int other);

// The same for a pair that the model lists, by its rules.
void collide_pair(const mjModel& model, mjData& data, int pair);

}  // namespace mimo::solver
