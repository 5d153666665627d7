// The rows of a step's constraints: which joints rub or are at a limit, and what touches.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// mj_makeConstraint, with the same numbers to the bit, but without the transposed Jacobian and the rows of equal
// pattern, which MuJoCo's own solvers and adhesion read. MuJoCo itself makes the rows of models with adhesion, with
// equalities that hold, friction of tendons or pyramidal cones; where there is no room for all; and where it would take
// a power of the C library that is not certain here.
void make_constraints(const mjModel& model, mjData& data);

// What the C library's pow gives for numbers from 0 to 1 and powers of .5, 1, 1.5 and 2; false for others, and where
// that is not certain.
bool find_power(double x, double power, double& found);

}  // namespace mimo::solver
