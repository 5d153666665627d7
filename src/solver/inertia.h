// The matrix of inertia and its factor, with the numbers of MuJoCo's mj_crb and mj_factorM to the bit; faster, because
// their innermost sums are of known length here.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// qM, and qLD with qLDiagInv. qLDiagSqrtInv, which only solvers of the dual problem need, stays as it is.
void update_inertia(const mjModel& model, mjData& data);

// mj_Euler: velocities move on with dampers taken at the end of the step.
void integrate(const mjModel& model, mjData& data);

}  // namespace mimo::solver
