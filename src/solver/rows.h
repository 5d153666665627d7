// The rows of a step's constraints: which joints rub or are at a limit, and what touches.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// mj_makeConstraint, with the same numbers to the bit, but without what only MuJoCo's own solvers read: the transposed
// Jacobian and the rows of equal pattern. MuJoCo itself makes rows where equalities, tendons or pyramidal cones are
// among them, or where there is no room for all.
void make_constraints(const mjModel& model, mjData& data);

}  // namespace mimo::solver
