// The solver's two matrices: inertia with its factor, and the Hessian of the solver's Newton steps.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include "solver/constraints.h"

namespace mimo::solver {

// The matrix of inertia and its factor, with the numbers of MuJoCo's mj_crb and mj_factorM to the bit; faster, because
// their innermost sums are of known length here.

// qM, and qLD with qLDiagInv. qLDiagSqrtInv, which only solvers of the dual problem need, stays as it is.
void update_inertia(const mjModel& model, mjData& data);

// mj_Euler: velocities move on with dampers taken at the end of the step.
void integrate(const mjModel& model, mjData& data);

// The matrix of the solver's Newton steps: inertia plus what active constraints add to it, in the accelerations of the
// degrees of freedom. Lies on the stack of mjData, as blocks do.

// The constraint of a single joint on a quiet row: friction, or a limit.
struct Single {
  int row;        // of the constraint
  int place;      // of what it adds to the matrix
  double weight;  // which is this, while it is a spring
  bool counted;   // in `halfway`
};

// The lower triangle, of which each row holds only what is not zero in the matrix or in its factor L'DL. That grows
// from the last row up: a model without contacts has the entries of its inertia and no others. Rows begin at multiples
// of four, so that numbers are added four at a time; what lies between rows means nothing.
//
// Quiet rows are those that no block of several columns reaches, by itself or by elimination: an arm in the air. All
// that they know of constraints is friction and limits of single joints, whose states change seldom, so that their part
// of the factor mostly lasts for several iterations.
struct Hessian {
  int size, entries;
  const int* starts;   // of each row in `columns` and the arrays below
  const int* ends;     // behind its diagonal, with which it ends
  const int* columns;  // ascending
  const double* inertia;
  const bool* quiet;  // rows
  double* values;     // of the matrix, then of its factor
  double* scratch;    // 7 x (size + 4)
  double* halfway;    // inertia and constraints of quiet rows, with these rows eliminated
  bool has_halfway;   // whether `halfway` is that of any states yet
  Single* singles;    // on quiet rows
  int single_count;
  int* loud;  // the other blocks
  int loud_count;
};

Hessian make_hessian(const mjModel& model, mjData& data, const Blocks& blocks);

void multiply_inertia(const Hessian& hessian, const double* vector, double* product);

// For the present states of the constraints and their violation; the matrix is replaced by its factor.
void factorize(Hessian& hessian, const mjData& data, const Blocks& blocks, const double* violation);
void solve(const Hessian& hessian, double* vector);

}  // namespace mimo::solver
