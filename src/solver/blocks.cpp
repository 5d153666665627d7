#include "solver/blocks.h"

#include <algorithm>

#include "solver/stack.h"

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

}  // namespace

Blocks gather_blocks(mjData& data) {
  if (data.nefc == 0) return {0, nullptr};
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
  return {count, blocks};
}

void multiply(const Blocks& blocks, const double* vector, double* product) {
  for (int i = 0; i < blocks.count; ++i) {
    const Block& block = blocks.all[i];
    switch (block.rows) {
      case 1: multiply_block<1>(block, vector, product); break;
      case 3: multiply_block<3>(block, vector, product); break;
      case 4: multiply_block<4>(block, vector, product); break;
      default: multiply_block<6>(block, vector, product);
    }
  }
}

void multiply_transposed(const Blocks& blocks, const double* vector, int size, double* product) {
  std::fill_n(product, size, 0.0);
  for (int i = 0; i < blocks.count; ++i) {
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

}  // namespace mimo::solver
