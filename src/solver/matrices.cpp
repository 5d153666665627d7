#include "solver/matrices.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdint>

#include "solver/constraints.h"
#include "solver/tree.h"

namespace mimo::solver {

#if MIMO_MUJOCO_4

void integrate(const mjModel& model, mjData& data) { mj_Euler(&model, &data); }

#else

namespace {

// Of each body with all that hangs on it.
void sum_inertias(const mjModel& model, mjData& data) {
  std::copy_n(data.cinert, 10 * model.nbody, data.crb);
  for (int body = model.nbody - 1; body > 0; --body) {
    const int parent = model.body_parentid[body];
    if (parent == 0) continue;
    for (int i = 0; i < 10; ++i) data.crb[10 * parent + i] += data.crb[10 * body + i];
  }
}

void fill_matrix(const mjModel& model, mjData& data) {
  std::fill_n(data.qM, model.nM, 0.0);
  for (int dof = 0; dof < model.nv; ++dof) {
    double* row = data.qM + model.dof_Madr[dof];
    if (model.dof_simplenum[dof] != 0) {
      *row = model.dof_M0[dof];
      continue;
    }
    double momentum[6];
    momentum_of(data.crb + 10 * model.dof_bodyid[dof], data.cdof + 6 * dof, momentum);
    *row = model.dof_armature[dof];
    for (int other = dof; other >= 0; other = model.dof_parentid[other])
      *row++ += dot6(data.cdof + 6 * other, momentum);
  }
}

// to[0 .. count) += numbers * factor, as wide as there are numbers.
void add_multiple(double* to, const double* numbers, double factor, int count) {
  int k = 0;
  for (; k + kLanes <= count; k += kLanes) {
    Lanes sum, number;
    read(to + k, sum);
    read(numbers + k, number);
    sum += number * factor;
    write(sum, to + k);
  }
  for (; k < count; ++k) to[k] += numbers[k] * factor;
}

// L'DL in the places of the matrix; rows are eliminated into those of the degrees of freedom that they hang on.
void factorize(const mjModel& model, mjData& data, double* factor, double* inverse) {
  for (int dof = model.nv - 1, end = model.nM; dof >= 0; end = model.dof_Madr[dof--]) {
    double* row = factor + model.dof_Madr[dof];
    if (*row < mjMINVAL) {
      mj_warning(&data, mjWARN_INERTIA, dof);
      *row = mjMINVAL;
    }
    const double diagonal = *row++;
    inverse[dof] = 1.0 / diagonal;
    if (model.dof_simplenum[dof] != 0) continue;
    int left = end - model.dof_Madr[dof] - 1;  // entries of the row
    for (int other = model.dof_parentid[dof]; other >= 0; other = model.dof_parentid[other], ++row, --left) {
      const double scale = *row / diagonal;
      add_multiple(factor + model.dof_Madr[other], row, -scale, left);
      *row = scale;
    }
  }
}

bool is_damped(const mjModel& model) {
  return std::any_of(model.dof_damping, model.dof_damping + model.nv, [](double damping) { return damping > 0; });
}

void solve(const mjModel& model, const double* factor, const double* inverse, double* vector) {
  for (int dof = model.nv - 1; dof >= 0; --dof) {
    if (model.dof_simplenum[dof] != 0) continue;
    const double value = vector[dof];
    const double* row = factor + model.dof_Madr[dof] + 1;
    for (int other = model.dof_parentid[dof]; other >= 0; other = model.dof_parentid[other]) {
      vector[other] -= *row++ * value;
    }
  }
  for (int dof = 0; dof < model.nv; ++dof) {
    double value = vector[dof] * inverse[dof];
    if (model.dof_simplenum[dof] == 0) {
      const double* row = factor + model.dof_Madr[dof] + 1;
      for (int other = model.dof_parentid[dof]; other >= 0; other = model.dof_parentid[other]) {
        value -= *row++ * vector[other];
      }
    }
    vector[dof] = value;
  }
}

void advance_activations(const mjModel& model, mjData& data) {
  for (int i = 0; i < model.na; ++i) {
    data.act[i] += data.act_dot[i] * model.opt.timestep;
    const int actuator = model.nu - model.na + i;
    if (model.actuator_actlimited[actuator] == 0) continue;
    const double* range = model.actuator_actrange + 2 * actuator;
    data.act[i] = mju_clip(data.act[i], range[0], range[1]);
  }
}

void advance(const mjModel& model, mjData& data, const double* accelerations) {
  advance_activations(model, data);
  mju_addToScl(data.qvel, accelerations, model.opt.timestep, model.nv);
  mj_integratePos(&model, data.qpos, data.qvel, model.opt.timestep);
  data.time += model.opt.timestep;
}

// The accelerations that a step ends with if its dampers act as they do at its end.
void damp(const mjModel& model, mjData& data, double* accelerations) {
  std::copy_n(data.qM, model.nM, data.qH);
  for (int dof = 0; dof < model.nv; ++dof) {
    data.qH[model.dof_Madr[dof]] += model.opt.timestep * model.dof_damping[dof];
  }
  factorize(model, data, data.qH, data.qHDiagInv);
  mju_add(accelerations, data.qfrc_smooth, data.qfrc_constraint, model.nv);
  solve(model, data.qH, data.qHDiagInv, accelerations);
}

}  // namespace

MIMO_ALSO_FOR_AVX2
void update_inertia(const mjModel& model, mjData& data) {
  sum_inertias(model, data);
  fill_matrix(model, data);
  std::copy_n(data.qM, model.nM, data.qLD);
  factorize(model, data, data.qLD, data.qLDiagInv);
}

MIMO_ALSO_FOR_AVX2
void integrate(const mjModel& model, mjData& data) {
  const compat::StackMark stack = compat::mark_stack(data);
  double* accelerations = take<double>(data, model.nv);
  if (is_damped(model)) {
    damp(model, data, accelerations);
  } else {
    std::copy_n(data.qacc, model.nv, accelerations);
  }
  advance(model, data, accelerations);
  compat::release_stack(data, stack);
}

#endif

namespace {

constexpr int kMostRows = 6;  // of a contact

Two two_at(const double* numbers) {
  Two two;
  read(numbers, two);
  return two;
}

// Room that begins with a line of the processor's cache, so that no lanes lie across two.
double* take_lines(mjData& data, int count) {
  constexpr std::uintptr_t kLine = 64;
  constexpr int kNumbers = kLine / sizeof(double);
  const auto room = reinterpret_cast<std::uintptr_t>(take<double>(data, count + kNumbers - 1));
  return reinterpret_cast<double*>((room + kLine - 1) / kLine * kLine);
}

int whole_lanes(int count) { return (count + kLanes - 1) / kLanes * kLanes; }

// sums[0 .. count) += factor * numbers, in whole lanes: both have room for them.
inline void add_scaled(double* __restrict sums, const double* __restrict numbers, double factor, int count) {
  for (int k = 0; k < count; k += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) sums[k + lane] += factor * numbers[k + lane];
  }
}

// A row of marks, one bit for each column.
using Word = std::uint64_t;
constexpr int kBits = 64;

int words_of(int size) { return (size + kBits - 1) / kBits; }
void mark(Word* row, int column) { row[column / kBits] |= Word{1} << (column % kBits); }

// Where the matrix itself is not zero. A block's columns meet in the rows of all of them; its last row will do, as
// elimination carries them up into the others.
void mark_entries(const mjModel& model, const Blocks& blocks, Word* marks) {
  const int words = words_of(model.nv);
  for (int dof = 0; dof < model.nv; ++dof) {
    Word* row = marks + dof * words;
    const int parent = model.dof_parentid[dof];
    if (parent < 0) {
      std::fill_n(row, words, Word{0});
    } else {
      std::copy_n(marks + parent * words, words, row);
    }
    mark(row, dof);
  }
  for (int i = 0; i < blocks.count; ++i) {
    const Block& block = blocks.all[i];
    if (block.width < 2) continue;
    Word* row = marks + block.columns[block.width - 1] * words;
    for (int k = 0; k < block.width; ++k) mark(row, block.columns[k]);
  }
}

int last_mark(const Word* row, int words) {
  while (words > 0 && row[words - 1] == 0) --words;
  return words == 0 ? -1 : words * kBits - 1 - __builtin_clzll(row[words - 1]);
}

// Eliminating a row leaves its entries in the row of the last of them but itself.
void fill_in(int size, Word* marks) {
  const int words = words_of(size);
  for (int row = size - 1; row > 0; --row) {
    Word* line = marks + row * words;
    const Word diagonal = Word{1} << (row % kBits);
    line[row / kBits] ^= diagonal;
    const int next = last_mark(line, row / kBits + 1);
    for (int i = 0; next >= 0 && i <= next / kBits; ++i) marks[next * words + i] |= line[i];
    line[row / kBits] ^= diagonal;
  }
}

int place_rows(int size, const Word* marks, int* starts, int* ends) {
  const int words = words_of(size);
  int at = 0;
  for (int row = 0; row < size; ++row) {
    starts[row] = ends[row] = at;
    for (int i = 0; i < words; ++i) ends[row] += __builtin_popcountll(marks[row * words + i]);
    at += whole_lanes(ends[row] - at);
  }
  return at;
}

void list_columns(int size, const Word* marks, const int* starts, int* columns) {
  const int words = words_of(size);
  for (int row = 0; row < size; ++row) {
    int* to = columns + starts[row];
    for (int i = 0; i < words; ++i) {
      for (Word rest = marks[row * words + i]; rest != 0; rest &= rest - 1) *to++ = i * kBits + __builtin_ctzll(rest);
    }
  }
}

// Adds to a row of the matrix numbers in some of its columns; mostly these are all.
inline void add_to_row(const Hessian& hessian, double* matrix, int row, int count, const int* columns,
                       const double* numbers, double factor) {
  const int start = hessian.starts[row];
  double* values = matrix + start;
  if (count == hessian.ends[row] - start) {
    add_scaled(values, numbers, factor, count);
    return;
  }
  const int* own = hessian.columns + start;
  for (int k = 0, at = 0; k < count; ++k) {
    while (own[at] != columns[k]) ++at;
    values[at] += factor * numbers[k];
  }
}

void write_inertia(const mjModel& model, const mjData& data, const Hessian& hessian, double* inertia) {
  std::fill_n(inertia, hessian.entries, 0.0);
  for (int dof = 0; dof < model.nv; ++dof) {
    int at = hessian.ends[dof] - 1;
    compat::visit_inertia(model, data, dof, [&](int other, double value) {
      while (hessian.columns[at] != other) --at;
      inertia[at--] = value;
    });
  }
}

// J' W J, where `weighted` is W J. Known numbers of rows keep a sum in a register.
template <int kRows>
void add_product_of(const Hessian& hessian, const Block& block, const double* weighted) {
  double* __restrict sums = hessian.scratch + kMostRows * (hessian.size + kLanes);
  const int width = block.width;
  for (int i = 0; i < width; ++i) {
    double factors[kRows];
    for (int r = 0; r < kRows; ++r) factors[r] = block.values[r * width + i];
    for (int k = 0; k <= i; k += kLanes) {
      for (int lane = 0; lane < kLanes; ++lane) {
        double sum = factors[0] * weighted[k + lane];
        for (int r = 1; r < kRows; ++r) sum += factors[r] * weighted[r * width + k + lane];
        sums[k + lane] = sum;
      }
    }
    add_to_row(hessian, hessian.values, block.columns[i], i + 1, block.columns, sums, 1);
  }
}

void add_product(const Hessian& hessian, const Block& block, const double* weighted) {
  switch (block.rows) {
    case 1: return add_product_of<1>(hessian, block, weighted);
    case 3: return add_product_of<3>(hessian, block, weighted);
    case 4: return add_product_of<4>(hessian, block, weighted);
    default: return add_product_of<6>(hessian, block, weighted);
  }
}

void weigh_evenly(const mjData& data, const Block& block, double* weighted) {
  for (int r = 0; r < block.rows; ++r) {
    for (int k = 0; k < block.width; ++k) {
      weighted[r * block.width + k] = data.efc_D[block.row + r] * block.values[r * block.width + k];
    }
  }
}

void weigh_slipping(const Slip& slip, const Block& block, double* weighted) {
  for (int k = 0; k < block.width; ++k) {
    const double* column = block.values + k;
    double slide = 0;
    for (int r = 1; r < block.rows; ++r) slide += slip.slide[r] * (slip.scales[r] * column[r * block.width]);
    const double across = slip.stiffness * (slip.scales[0] * column[0] - slip.friction * slide);
    weighted[k] = slip.scales[0] * across;
    const double bend = slip.stiffness * slip.bend, along = bend * slide + slip.friction * across;
    for (int r = 1; r < block.rows; ++r) {
      const double scaled = slip.scales[r] * column[r * block.width];
      weighted[r * block.width + k] = slip.scales[r] * (bend * scaled - slip.slide[r] * along);
    }
  }
}

bool is_single(const Block& block) { return block.rows == 1 && block.width == 1; }
bool is_quiet(const Hessian& hessian, const Block& block) {
  return is_single(block) && hessian.quiet[block.columns[0]];
}

void add_single(const Hessian& hessian, const mjData& data, const Block& block, double* matrix) {
  matrix[hessian.ends[block.columns[0]] - 1] += data.efc_D[block.row] * block.values[0] * block.values[0];
}

void add_block(const Hessian& hessian, const mjData& data, const Block& block, const double* violation) {
  const int state = data.efc_state[block.row];
  if (state == mjCNSTRSTATE_QUADRATIC && is_single(block)) {
    add_single(hessian, data, block, hessian.values);
  } else if (state == mjCNSTRSTATE_QUADRATIC) {
    weigh_evenly(data, block, hessian.scratch);
    add_product(hessian, block, hessian.scratch);
  } else if (state == mjCNSTRSTATE_CONE) {
    weigh_slipping(slip_of(data, block, violation), block, hessian.scratch);
    add_product(hessian, block, hessian.scratch);
  }
}

void find_quiet(const Hessian& hessian, const Blocks& blocks, bool* quiet) {
  std::fill_n(quiet, hessian.size, true);
  for (int i = 0; i < blocks.count; ++i) {
    const Block& block = blocks.all[i];
    for (int k = 0; k < block.width && !is_single(block); ++k) quiet[block.columns[k]] = false;
  }
  for (int row = hessian.size - 1; row >= 0; --row) {
    for (int at = hessian.starts[row]; at < hessian.ends[row] && !quiet[row]; ++at) quiet[hessian.columns[at]] = false;
  }
}

// Which blocks are on quiet rows, and which are not.
void sort_blocks(Hessian& hessian, const mjData& data, const Blocks& blocks) {
  for (int i = 0; i < blocks.count; ++i) {
    const Block& block = blocks.all[i];
    if (is_quiet(hessian, block)) {
      const double weight = data.efc_D[block.row] * block.values[0] * block.values[0];
      hessian.singles[hessian.single_count++] = {block.row, hessian.ends[block.columns[0]] - 1, weight, false};
    } else {
      hessian.loud[hessian.loud_count++] = i;
    }
  }
}

// Rows of one kind, into those above them.
void eliminate(const Hessian& hessian, bool quiet, double* matrix) {
  double* line = hessian.scratch;
  for (int row = hessian.size - 1; row >= 0; --row) {
    if (hessian.quiet[row] != quiet) continue;
    double* values = matrix + hessian.starts[row];
    const int* columns = hessian.columns + hessian.starts[row];
    const int count = hessian.ends[row] - hessian.starts[row] - 1;  // without the diagonal
    values[count] = std::max(values[count], mjMINVAL);
    const double inverse = 1 / values[count];
    std::copy_n(values, count, line);
    for (int i = 0; i < count; ++i) {
      values[i] = line[i] * inverse;
      add_to_row(hessian, matrix, columns[i], i + 1, columns, line, -values[i]);
    }
  }
}

// Whether the quiet rows' constraints are in other states than when these were eliminated; notes the present ones.
bool quiet_changed(Hessian& hessian, const mjData& data) {
  bool changed = !hessian.has_halfway;
  hessian.has_halfway = true;
  for (int i = 0; i < hessian.single_count; ++i) {
    Single& single = hessian.singles[i];
    const bool counts = data.efc_state[single.row] == mjCNSTRSTATE_QUADRATIC;
    changed |= single.counted != counts;
    single.counted = counts;
  }
  return changed;
}

void go_halfway(const Hessian& hessian) {
  std::copy_n(hessian.inertia, hessian.entries, hessian.halfway);
  for (int i = 0; i < hessian.single_count; ++i) {
    const Single& single = hessian.singles[i];
    if (single.counted) hessian.halfway[single.place] += single.weight;
  }
  eliminate(hessian, true, hessian.halfway);
}

}  // namespace

MIMO_ALSO_FOR_AVX2
Hessian make_hessian(const mjModel& model, mjData& data, const Blocks& blocks) {
  const int size = model.nv;
  int* starts = take<int>(data, size);
  int* ends = take<int>(data, size);
  Word* marks = take<Word>(data, size * words_of(size));
  mark_entries(model, blocks, marks);
  fill_in(size, marks);
  const int entries = place_rows(size, marks, starts, ends);
  int* columns = take<int>(data, entries);
  list_columns(size, marks, starts, columns);
  double* inertia = take_lines(data, entries);
  bool* quiet = take<bool>(data, size);
  const int room = (kMostRows + 1) * (size + kLanes);
  Hessian hessian{};
  hessian.size = size;
  hessian.entries = entries;
  hessian.starts = starts;
  hessian.ends = ends;
  hessian.columns = columns;
  hessian.inertia = inertia;
  hessian.quiet = quiet;
  hessian.values = take_lines(data, entries);
  hessian.scratch = take_lines(data, room);
  hessian.halfway = take_lines(data, entries);
  hessian.singles = take<Single>(data, blocks.count);
  hessian.loud = take<int>(data, blocks.count);
  write_inertia(model, data, hessian, inertia);
  std::fill_n(hessian.scratch, room, 0.0);
  find_quiet(hessian, blocks, quiet);
  sort_blocks(hessian, data, blocks);
  return hessian;
}

MIMO_ALSO_FOR_AVX2
void multiply_inertia(const Hessian& hessian, const double* __restrict vector, double* __restrict product) {
  const int *starts = hessian.starts, *ends = hessian.ends, *columns = hessian.columns, size = hessian.size;
  const double* inertia = hessian.inertia;
  for (int row = 0; row < size; ++row) {
    const int diagonal = ends[row] - 1;
    const double value = vector[row];
    Two sums = {inertia[diagonal] * value, 0};  // two, as each waits for itself
    int at = starts[row];
    for (; at + 1 < diagonal; at += 2) {
      const int first = columns[at], second = columns[at + 1];
      sums += two_at(inertia + at) * Two{vector[first], vector[second]};
      if (second == first + 1) {
        write(two_at(product + first) + two_at(inertia + at) * value, product + first);
      } else {
        product[first] += inertia[at] * value;
        product[second] += inertia[at + 1] * value;
      }
    }
    if (at < diagonal) {
      sums[0] += inertia[at] * vector[columns[at]];
      product[columns[at]] += inertia[at] * value;
    }
    product[row] = sums[0] + sums[1];
  }
}

MIMO_ALSO_FOR_AVX2
void factorize(Hessian& hessian, const mjData& data, const Blocks& blocks, const double* violation) {
  if (quiet_changed(hessian, data)) go_halfway(hessian);
  std::copy_n(hessian.halfway, hessian.entries, hessian.values);
  for (int i = 0; i < hessian.loud_count; ++i) add_block(hessian, data, blocks.all[hessian.loud[i]], violation);
  eliminate(hessian, false, hessian.values);
}

MIMO_ALSO_FOR_AVX2
void solve(const Hessian& hessian, double* vector) {
  const int *starts = hessian.starts, *ends = hessian.ends, *columns = hessian.columns, size = hessian.size;
  const double* values = hessian.values;
  for (int row = size - 1; row >= 0; --row) {
    const double value = vector[row];
    const int diagonal = ends[row] - 1;
    int at = starts[row];
    for (; at + 1 < diagonal; at += 2) {
      const int first = columns[at], second = columns[at + 1];
      if (second == first + 1) {
        write(two_at(vector + first) - two_at(values + at) * value, vector + first);
      } else {
        vector[first] -= values[at] * value;
        vector[second] -= values[at + 1] * value;
      }
    }
    if (at < diagonal) vector[columns[at]] -= values[at] * value;
  }
  for (int row = 0; row < size; ++row) {
    const int diagonal = ends[row] - 1;
    Two sums = {vector[row] / values[diagonal], 0};  // two, as each waits for itself
    int at = starts[row];
    for (; at + 1 < diagonal; at += 2) {
      sums -= two_at(values + at) * Two{vector[columns[at]], vector[columns[at + 1]]};
    }
    if (at < diagonal) sums[0] -= values[at] * vector[columns[at]];
    vector[row] = sums[0] + sums[1];
  }
}

}  // namespace mimo::solver
