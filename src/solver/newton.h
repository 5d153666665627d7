// A physics step with libmimo's own solver for the forces of constraints: Newton's method with an exact line search.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// How far to go along a direction: the least of the solver's cost on a line.

// The cost along a line is convex: of second order for every row in a state that lasts, and cones.
struct Line {
  const double* start;      // J qacc - aref of each row
  const double* direction;  // and how it changes along the line
  double slope, curvature;  // of the part without constraints, at the start
};

// Where the slope is within the tolerance of zero, or as near as numbers allow; 0 if the cost does not fall along the
// line.
double find_least(mjData& data, const Line& line, double tolerance);

// A physics step with a solver of our own for the forces of constraints: Newton's method with an exact line search, as
// MuJoCo's. The same problem, the same steps and the same end, so the same numbers to rounding; what is ours is how the
// matrix of a step is put together and factorised (docs/adr/0011-newton-solver.md).

// Whether newton_step does all that mj_step would: a Newton solver with a sparse Jacobian and Euler's method, as the
// built-in scenes ask for, and nothing out of the ordinary.
bool newton_step_serves(const mjModel& model);

// mj_step, with our solver in the place of mj_fwdConstraint, and on MuJoCo 2.2.2 with stages of our own that give the
// same numbers (solver/tree.h, rows.h, matrices.h, collision.h). Like MuJoCo it takes its room from mjData's stack, and
// leaves by MuJoCo's error where that is too small. Not filled in are mjData.solver, its timers of stages within a
// step, the transposed Jacobian (efc_JT and its indices) and rows of equal pattern (efc_J_rowsuper is zero), and the
// warnings of a solver that gets stuck; a matrix that is singular to rounding is solved all the same.
void newton_step(const mjModel* model, mjData* data);

}  // namespace mimo::solver
