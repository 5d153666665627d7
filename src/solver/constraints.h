// The constraints of a step: their Jacobian as the solver reads it, their forces, and what a violation costs.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

#include <cstring>
#include <type_traits>

#include "compat/mujoco.h"

// Functions with this are compiled twice, with everything that they call: for any processor and for one with AVX2,
// which the loader chooses by itself. Operations and their order stay the same, and so do the bytes. Only GNU's loader
// and compiler can; sanitizers have not started yet when the loader asks.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define MIMO_ALSO_FOR_AVX2 __attribute__((target_clones("avx2", "default"), flatten))
#else
#define MIMO_ALSO_FOR_AVX2
#endif

namespace mimo::solver {

// Numbers that are calculated at once, each as if it were alone. Compilers do that by themselves only where they see
// that it pays. These types are no parameters and no results of functions: a processor without AVX has no registers for
// them.
constexpr int kLanes = 4;
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));
typedef double Two __attribute__((vector_size(2 * sizeof(double))));

template <typename Vector>
void read(const double* numbers, Vector& vector) {
  std::memcpy(&vector, numbers, sizeof vector);
}
template <typename Vector>
void write(const Vector& vector, double* numbers) {
  std::memcpy(numbers, &vector, sizeof vector);
}

// Room on mjData's own stack, as MuJoCo's solvers take it: too little is MuJoCo's error.

// Uninitialised; whoever marks the stack before and releases it gives it free.
template <typename T>
T* take(mjData& data, int count) {
  static_assert(std::is_trivial_v<T> && alignof(T) <= alignof(mjtNum));
  return reinterpret_cast<T*>(compat::take_stack(data, static_cast<std::size_t>(count) * sizeof(T)));
}

// The Jacobian of a step's constraints, as the solver reads it. Everything lies on the stack of mjData and is forgotten
// with it; nothing here has a destructor, as MuJoCo may leave the calling function by an error.

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
  int singles;  // so many at the beginning are a row of one column each; their columns and values lie side by side
};

Blocks gather_blocks(mjData& data);

// J v
void multiply(const Blocks& blocks, const double* vector, double* product);
// J' v, of `size` numbers
void multiply_transposed(const Blocks& blocks, const double* vector, int size, double* product);

// What constraints do where they are violated: their forces, and what the violation costs.

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
