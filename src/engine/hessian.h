// The matrix of the solver's Newton steps: inertia plus what active constraints add to it, in the accelerations of the
// degrees of freedom. Everything lies on the stack of mjData and is forgotten with it; nothing here has a destructor,
// as MuJoCo may leave the calling function by an error.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::engine {

// Rows of the Jacobian that belong together, a contact's or a single one, without the columns in which all are zero.
// Where two parts of one body touch that is all that moves both alike, which is most of it.
struct Block {
  int row, rows, width;
  const int* columns;    // ascending, as MuJoCo keeps them
  const double* values;  // rows x width
};

struct Blocks {
  int count;
  const Block* all;
};

// The lower triangle, of which each row holds only what is not zero in the matrix or in its factor L'DL. That grows
// from the last row up: a model without contacts has the entries of its inertia and no others.
struct Hessian {
  int size;
  const int* starts;   // of each row in `columns` and the arrays below, and the end of the last
  const int* columns;  // ascending; a row ends with its diagonal
  const double* inertia;
  double* values;   // of the matrix, then of its factor
  double* scratch;  // 7 x size
};

Blocks gather_blocks(mjData& data);
Hessian make_hessian(const mjModel& model, mjData& data, const Blocks& blocks);

void multiply_inertia(const Hessian& hessian, const double* vector, double* product);

// For the present states of the constraints; the matrix is replaced by its factor.
void factorize(const Hessian& hessian, const mjData& data, const Blocks& blocks);
void solve(const Hessian& hessian, double* vector);

}  // namespace mimo::engine
