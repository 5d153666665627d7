// A quick look at two shapes before MuJoCo's thorough one.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// True only if a plane parts two shapes by more than the margin, so that there is no contact to be found. Not all such
// pairs are told: looked at are the few planes that part most neighbours, and pairs that are not found out about as
// quickly otherwise.
bool are_apart(const mjModel& model, const mjData& data, int geom, int other, double margin);

}  // namespace mimo::solver
