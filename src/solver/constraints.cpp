#include "solver/constraints.h"

#include <algorithm>
#include <cmath>

namespace mimo::solver {
namespace {

bool any_value(const mjData& data, int row, int rows, int at) {
  for (int i = row; i < row + rows; ++i) {
    if (data.efc_J[data.efc_J_rowadr[i] + at] != 0) return true;
  }
  return false;
}

// Known numbers of rows keep their sums in registers.
template <int kRows>
void multiply_block(const Block& block, const double* vector, double* product) {
  double sums[kRows] = {};
  for (int k = 0; k < block.width; ++k) {
    const double value = vector[block.columns[k]];
    for (int r = 0; r < kRows; ++r) sums[r] += block.values[r * block.width + k] * value;
  }
  std::copy_n(sums, kRows, product + block.row);
}

template <int kRows>
void multiply_transposed_block(const Block& block, const double* vector, double* product) {
  const double* factors = vector + block.row;
  for (int k = 0; k < block.width; ++k) {
    double sum = 0;
    for (int r = 0; r < kRows; ++r) sum += block.values[r * block.width + k] * factors[r];
    product[block.columns[k]] += sum;
  }
}

bool is_zero(const double* numbers, int count) {
  return std::all_of(numbers, numbers + count, [](double x) { return x == 0; });
}

double square_cost(const mjData& data, int row, int rows, const double* violation) {
  double cost = 0;
  for (int i = row; i < row + rows; ++i) cost += 0.5 * data.efc_D[i] * violation[i] * violation[i];
  return cost;
}

// Where a contact's violation lies, by its normal and tangential parts.
struct Place {
  double normal, tangent;
  mjtConstraintState state;
};

Place place_of(const mjContact& contact, const double* violation) {
  double square = 0;
  for (int i = 1; i < contact.dim; ++i) {
    const double across = violation[i] * contact.friction[i - 1];
    square += across * across;
  }
  const double mu = contact.mu, normal = violation[0] * mu, tangent = std::sqrt(square);
  if (normal >= mu * tangent || (tangent <= 0 && normal >= 0)) return {normal, tangent, mjCNSTRSTATE_SATISFIED};
  if (mu * normal + tangent <= 0 || (tangent <= 0 && normal < 0)) return {normal, tangent, mjCNSTRSTATE_QUADRATIC};
  return {normal, tangent, mjCNSTRSTATE_CONE};
}

double cone_stiffness(const mjData& data, const mjContact& contact, int row) {
  const double square = contact.mu * contact.mu;
  return data.efc_D[row] / (square * (1 + square));
}

// `write(row, state, force)` takes what the row does.
template <typename Write>
double visit_cone(const mjData& data, const Block& block, const double* violation, Write&& write) {
  const mjContact& contact = data.contact[data.efc_id[block.row]];
  const double* own = violation + block.row;
  const Place place = place_of(contact, own);
  if (place.state == mjCNSTRSTATE_SATISFIED) {
    for (int i = 0; i < block.rows; ++i) write(block.row + i, place.state, 0.0);
    return 0;
  }
  if (place.state == mjCNSTRSTATE_QUADRATIC) {
    for (int i = 0; i < block.rows; ++i) write(block.row + i, place.state, -data.efc_D[block.row + i] * own[i]);
    return square_cost(data, block.row, block.rows, violation);
  }
  const double stiffness = cone_stiffness(data, contact, block.row);
  const double depth = place.normal - contact.mu * place.tangent;
  const double force = -stiffness * depth * contact.mu, across = -force / place.tangent;
  write(block.row, place.state, force);
  for (int i = 1; i < block.rows; ++i) {
    const double friction = contact.friction[i - 1];
    write(block.row + i, place.state, across * (own[i] * friction) * friction);
  }
  return 0.5 * stiffness * depth * depth;
}

// Friction of a joint or tendon: a force of this size against any movement, and less very near to rest.
template <typename Write>
double visit_friction(const mjData& data, int row, const double* violation, Write&& write) {
  const double loss = data.efc_frictionloss[row], bound = data.efc_R[row] * loss, value = violation[row];
  if (value <= -bound) {
    write(row, mjCNSTRSTATE_LINEARNEG, loss);
    return -0.5 * bound * loss - loss * value;
  }
  if (value >= bound) {
    write(row, mjCNSTRSTATE_LINEARPOS, -loss);
    return -0.5 * bound * loss + loss * value;
  }
  write(row, mjCNSTRSTATE_QUADRATIC, -data.efc_D[row] * value);
  return square_cost(data, row, 1, violation);
}

template <typename Write>
double visit_single(const mjData& data, int row, const double* violation, Write&& write) {
  if (row >= data.ne && row < data.ne + data.nf) return visit_friction(data, row, violation, write);
  if (row >= data.ne + data.nf && violation[row] >= 0) {
    write(row, mjCNSTRSTATE_SATISFIED, 0.0);
    return 0;
  }
  write(row, mjCNSTRSTATE_QUADRATIC, -data.efc_D[row] * violation[row]);
  return square_cost(data, row, 1, violation);
}

template <typename Write>
double visit(const mjData& data, const Blocks& blocks, const double* violation, Write&& write) {
  double cost = 0;
  for (int i = 0; i < blocks.count; ++i) {
    const Block& block = blocks.all[i];
    cost += block.cone ? visit_cone(data, block, violation, write) : visit_single(data, block.row, violation, write);
  }
  return cost;
}

}  // namespace

MIMO_ALSO_FOR_AVX2
Blocks gather_blocks(mjData& data) {
  if (data.nefc == 0) return {0, nullptr, 0};
  const int last = data.nefc - 1;
  const int entries = data.efc_J_rowadr[last] + data.efc_J_rownnz[last];
  Block* blocks = take<Block>(data, data.nefc);
  int* columns = take<int>(data, entries);
  double* values = take<double>(data, entries);
  int count = 0;
  for (int row = 0; row < data.nefc;) {
    const bool cone = data.efc_type[row] == mjCNSTR_CONTACT_ELLIPTIC;
    Block& block = blocks[count++];
    block = {row, cone ? data.contact[data.efc_id[row]].dim : 1, 0, cone, columns, values};
    const int first = data.efc_J_rowadr[row];
    for (int at = 0; at < data.efc_J_rownnz[row]; ++at) {
      if (any_value(data, row, block.rows, at)) columns[block.width++] = at;
    }
    for (int r = 0; r < block.rows; ++r) {
      const double* line = data.efc_J + data.efc_J_rowadr[row + r];
      for (int k = 0; k < block.width; ++k) values[r * block.width + k] = line[columns[k]];
    }
    for (int k = 0; k < block.width; ++k) columns[k] = data.efc_J_colind[first + columns[k]];
    columns += block.width;
    values += block.rows * block.width;
    row += block.rows;
  }
  int singles = 0;
  while (singles < count && blocks[singles].rows == 1 && blocks[singles].width == 1) ++singles;
  return {count, blocks, singles};
}

MIMO_ALSO_FOR_AVX2
void multiply(const Blocks& blocks, const double* vector, double* product) {
  for (int i = 0; i < blocks.singles; ++i) product[i] = 0.0 + blocks.all->values[i] * vector[blocks.all->columns[i]];
  for (int i = blocks.singles; i < blocks.count; ++i) {
    const Block& block = blocks.all[i];
    switch (block.rows) {
      case 1: multiply_block<1>(block, vector, product); break;
      case 3: multiply_block<3>(block, vector, product); break;
      case 4: multiply_block<4>(block, vector, product); break;
      default: multiply_block<6>(block, vector, product);
    }
  }
}

MIMO_ALSO_FOR_AVX2
void multiply_transposed(const Blocks& blocks, const double* vector, int size, double* product) {
  std::fill_n(product, size, 0.0);
  for (int i = 0; i < blocks.singles; ++i) product[blocks.all->columns[i]] += 0.0 + blocks.all->values[i] * vector[i];
  for (int i = blocks.singles; i < blocks.count; ++i) {
    const Block& block = blocks.all[i];
    if (is_zero(vector + block.row, block.rows)) continue;
    switch (block.rows) {
      case 1: multiply_transposed_block<1>(block, vector, product); break;
      case 3: multiply_transposed_block<3>(block, vector, product); break;
      case 4: multiply_transposed_block<4>(block, vector, product); break;
      default: multiply_transposed_block<6>(block, vector, product);
    }
  }
}

double cost_of(const mjData& data, const Blocks& blocks, const double* violation) {
  return visit(data, blocks, violation, [](int, mjtConstraintState, double) {});
}

MIMO_ALSO_FOR_AVX2
double update_states(mjData& data, const Blocks& blocks, const double* violation) {
  return visit(data, blocks, violation, [&](int row, mjtConstraintState state, double force) {
    data.efc_state[row] = state;
    data.efc_force[row] = force;
  });
}

Slip slip_of(const mjData& data, const Block& block, const double* violation) {
  const mjContact& contact = data.contact[data.efc_id[block.row]];
  const double* own = violation + block.row;
  const Place place = place_of(contact, own);
  const double mu = contact.mu;
  Slip slip;
  slip.friction = mu;
  slip.scales[0] = mu;
  slip.slide[0] = 0;
  for (int i = 1; i < block.rows; ++i) {
    slip.scales[i] = contact.friction[i - 1];
    slip.slide[i] = own[i] * contact.friction[i - 1] / place.tangent;
  }
  slip.stiffness = cone_stiffness(data, contact, block.row);
  slip.bend = mu * mu - mu * place.normal / place.tangent;
  return slip;
}

}  // namespace mimo::solver
