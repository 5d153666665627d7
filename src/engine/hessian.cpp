#include "engine/hessian.h"

#include <algorithm>

#include "engine/solver_stack.h"

namespace mimo::engine {
namespace {

constexpr int kMostRows = 6;  // of a contact

bool any_value(const mjData& data, int row, int rows, int at) {
  for (int i = row; i < row + rows; ++i) {
    if (data.efc_J[data.efc_J_rowadr[i] + at] != 0) return true;
  }
  return false;
}

using Mark = unsigned char;

// Where the matrix itself is not zero. A block's columns meet in the rows of all of them; its last row will do, as
// elimination carries them up into the others.
void mark_entries(const mjModel& model, const Blocks& blocks, Mark* marks) {
  for (int dof = 0; dof < model.nv; ++dof) {
    for (int other = dof; other >= 0; other = model.dof_parentid[other]) marks[dof * model.nv + other] = 1;
  }
  for (int i = 0; i < blocks.count; ++i) {
    const Block& block = blocks.all[i];
    for (int k = 0; k < block.width; ++k) marks[block.columns[block.width - 1] * model.nv + block.columns[k]] = 1;
  }
}

// Eliminating a row leaves its entries in the row of the last of them. Returns how many there are then.
int fill_in(int size, Mark* marks) {
  int entries = 0;
  for (int row = size - 1; row >= 0; --row) {
    const Mark* line = marks + row * size;
    int next = row - 1;
    while (next >= 0 && line[next] == 0) --next;
    for (int column = 0; column <= next; ++column) marks[next * size + column] |= line[column];
    for (int column = 0; column <= row; ++column) entries += line[column];
  }
  return entries;
}

void list_columns(int size, const Mark* marks, int* starts, int* columns) {
  int count = 0;
  for (int row = 0; row < size; ++row) {
    starts[row] = count;
    for (int column = 0; column <= row; ++column) {
      if (marks[row * size + column] != 0) columns[count++] = column;
    }
  }
  starts[size] = count;
}

// Adds to a row of the matrix numbers in some of its columns; mostly these are all.
inline void add_to_row(const Hessian& hessian, int row, int count, const int* columns, const double* __restrict numbers,
                       double factor) {
  const int start = hessian.starts[row];
  const int* own = hessian.columns + start;
  double* __restrict values = hessian.values + start;
  if (count == hessian.starts[row + 1] - start) {
    for (int k = 0; k < count; ++k) values[k] += factor * numbers[k];
    return;
  }
  for (int k = 0, at = 0; k < count; ++k) {
    while (own[at] != columns[k]) ++at;
    values[at] += factor * numbers[k];
  }
}

void write_inertia(const mjModel& model, const mjData& data, const int* starts, const int* columns, double* inertia) {
  for (int dof = 0; dof < model.nv; ++dof) {
    int at = starts[dof + 1] - 1;
    compat::visit_inertia(model, data, dof, [&](int other, double value) {
      for (; columns[at] != other; --at) inertia[at] = 0;
      inertia[at--] = value;
    });
    for (; at >= starts[dof]; --at) inertia[at] = 0;
  }
}

// J' W J, where `weighted` is W J.
void add_product(const Hessian& hessian, const Block& block, const double* weighted) {
  double* sums = hessian.scratch + kMostRows * hessian.size;
  for (int i = 0; i < block.width; ++i) {
    std::fill_n(sums, i + 1, 0.0);
    for (int r = 0; r < block.rows; ++r) {
      const double factor = block.values[r * block.width + i];
      const double* line = weighted + r * block.width;
      for (int k = 0; k <= i; ++k) sums[k] += factor * line[k];
    }
    add_to_row(hessian, block.columns[i], i + 1, block.columns, sums, 1);
  }
}

void add_block(const Hessian& hessian, const mjData& data, const Block& block) {
  double* weighted = hessian.scratch;
  const int state = data.efc_state[block.row];
  if (state == mjCNSTRSTATE_QUADRATIC) {
    for (int r = 0; r < block.rows; ++r) {
      for (int k = 0; k < block.width; ++k) {
        weighted[r * block.width + k] = data.efc_D[block.row + r] * block.values[r * block.width + k];
      }
    }
  } else if (state == mjCNSTRSTATE_CONE) {
    const double* cone = data.contact[data.efc_id[block.row]].H;
    std::fill_n(weighted, block.rows * block.width, 0.0);
    for (int r = 0; r < block.rows; ++r) {
      for (int s = 0; s < block.rows; ++s) {
        const double factor = cone[r * block.rows + s];
        for (int k = 0; k < block.width; ++k)
          weighted[r * block.width + k] += factor * block.values[s * block.width + k];
      }
    }
  } else {
    return;
  }
  add_product(hessian, block, weighted);
}

}  // namespace

Blocks gather_blocks(mjData& data) {
  const int last = data.nefc - 1;
  const int entries = data.efc_J_rowadr[last] + data.efc_J_rownnz[last];
  Block* blocks = take<Block>(data, data.nefc);
  int* columns = take<int>(data, entries);
  double* values = take<double>(data, entries);
  int count = 0;
  for (int row = 0; row < data.nefc;) {
    const bool cone = data.efc_type[row] == mjCNSTR_CONTACT_ELLIPTIC;
    Block& block = blocks[count++];
    block = {row, cone ? data.contact[data.efc_id[row]].dim : 1, 0, columns, values};
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

Hessian make_hessian(const mjModel& model, mjData& data, const Blocks& blocks) {
  const int size = model.nv;
  int* starts = take<int>(data, size + 1);
  Mark* marks = take<Mark>(data, size * size);
  std::fill_n(marks, size * size, Mark{0});
  mark_entries(model, blocks, marks);
  const int entries = fill_in(size, marks);
  int* columns = take<int>(data, entries);
  list_columns(size, marks, starts, columns);
  double* inertia = take<double>(data, entries);
  write_inertia(model, data, starts, columns, inertia);
  return {size, starts, columns, inertia, take<double>(data, entries), take<double>(data, (kMostRows + 1) * size)};
}

void multiply_inertia(const Hessian& hessian, const double* vector, double* product) {
  for (int row = 0; row < hessian.size; ++row) {
    const int diagonal = hessian.starts[row + 1] - 1;
    double sum = hessian.inertia[diagonal] * vector[row];
    for (int at = hessian.starts[row]; at < diagonal; ++at) {
      sum += hessian.inertia[at] * vector[hessian.columns[at]];
      product[hessian.columns[at]] += hessian.inertia[at] * vector[row];
    }
    product[row] = sum;
  }
}

void factorize(const Hessian& hessian, const mjData& data, const Blocks& blocks) {
  std::copy_n(hessian.inertia, hessian.starts[hessian.size], hessian.values);
  for (int i = 0; i < blocks.count; ++i) add_block(hessian, data, blocks.all[i]);
  double* line = hessian.scratch;
  for (int row = hessian.size - 1; row >= 0; --row) {
    double* values = hessian.values + hessian.starts[row];
    const int* columns = hessian.columns + hessian.starts[row];
    const int count = hessian.starts[row + 1] - hessian.starts[row] - 1;  // without the diagonal
    values[count] = std::max(values[count], mjMINVAL);
    const double inverse = 1 / values[count];
    std::copy_n(values, count, line);
    for (int i = 0; i < count; ++i) {
      values[i] = line[i] * inverse;
      add_to_row(hessian, columns[i], i + 1, columns, line, -values[i]);
    }
  }
}

void solve(const Hessian& hessian, double* vector) {
  for (int row = hessian.size - 1; row >= 0; --row) {
    const double value = vector[row];
    for (int at = hessian.starts[row]; at < hessian.starts[row + 1] - 1; ++at) {
      vector[hessian.columns[at]] -= hessian.values[at] * value;
    }
  }
  for (int row = 0; row < hessian.size; ++row) {
    const int diagonal = hessian.starts[row + 1] - 1;
    double value = vector[row] / hessian.values[diagonal];
    for (int at = hessian.starts[row]; at < diagonal; ++at) value -= hessian.values[at] * vector[hessian.columns[at]];
    vector[row] = value;
  }
}

}  // namespace mimo::engine
