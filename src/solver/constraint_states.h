// What constraints do where they are violated: their forces, and what the violation costs.
#pragma once

#include "solver/blocks.h"

namespace mimo::solver {

// The cost of a violation J a - aref.
double cost_of(const mjData& data, const Blocks& blocks, const double* violation);

// The same, and fills efc_state and efc_force.
double update_states(mjData& data, const Blocks& blocks, const double* violation);

// How the cost of an elliptic contact that slips bends, in the space in which its cone is round: there the second
// derivative is stiffness * (q q' + bend * (1 - u u')), the latter for the tangential part only. u is the direction of
// the slip and q = (1, -friction * u).
struct Slip {
  double friction;
  double scales[6];  // into that space
  double slide[6];   // u; slide[0] is 0
  double stiffness, bend;
};
Slip slip_of(const mjData& data, const Block& block, const double* violation);

}  // namespace mimo::solver
