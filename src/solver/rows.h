// The rows of a step's constraints: which joints rub or are at a limit, and what touches.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// mj_makeConstraint, with the same numbers to the bit, but without the transposed Jacobian and the rows of equal
// pattern, which MuJoCo's own solvers and adhesion read. MuJoCo itself makes the rows of models with adhesion, with
// equalities that hold, friction of tendons or pyramidal cones, and where there is no room for all.
void make_constraints(const mjModel& model, mjData& data);

}  // namespace mimo::solver
