// The Jacobian of a step's constraints, as the solver reads it. Everything lies on the stack of mjData and is forgotten
// with it; nothing here has a destructor, as MuJoCo may leave the calling function by an error.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// Rows of the Jacobian that belong together, a contact's or a single one, without the columns in which all are zero.
// Where two parts of one body touch that is all that moves both alike, which is most of it.
struct Block {
  int row, rows, width;
  bool cone;             // an elliptic contact
  const int* columns;    // ascending, as MuJoCo keeps them
  const double* values;  // rows x width
};

struct Blocks {
  int count;
  const Block* all;
};

Blocks gather_blocks(mjData& data);

// J v
void multiply(const Blocks& blocks, const double* vector, double* product);
// J' v, of `size` numbers
void multiply_transposed(const Blocks& blocks, const double* vector, int size, double* product);

}  // namespace mimo::solver
