#include "solver/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/collision.h"
#include "solver/constraints.h"
#include "solver/matrices.h"
#include "solver/rows.h"
#include "solver/tree.h"

namespace mimo::solver {
namespace {

constexpr int kMostEvaluations = 50;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Slope {
  double first, second;  // derivatives of the cost
};

// Rows that stand for themselves. All are springs within their bounds: friction of joints yields at both, limits and
// contacts without friction only push, equalities have none. As many as fill whole lanes; the last ones weigh nothing.
struct Springs {
  int count;
  double *start, *change, *low, *high;
  double* weight;  // stiffness times change
};

// A contact with friction, in units in which its cone is round.
struct Cone {
  double friction, friction_square;
  double normal, normal_change;
  double tangent, tangent_mixed, tangent_change;  // square of the tangential part: t + 2 a m + a^2 c
  double stiffness;
  double slope, curvature;  // while the contact sticks
};

struct Terms {
  Springs springs;
  int count;
  const Cone* cones;
};

Cone cone_of(const mjData& data, const Line& line, int row) {
  const mjContact& contact = data.contact[data.efc_id[row]];
  const double mu = contact.mu;
  Cone cone{};
  cone.friction = mu;
  cone.friction_square = mu * mu;
  cone.normal = line.start[row] * mu;
  cone.normal_change = line.direction[row] * mu;
  for (int i = 0; i < contact.dim; ++i) {
    const double start = line.start[row + i], change = line.direction[row + i];
    cone.slope += data.efc_D[row + i] * start * change;
    cone.curvature += data.efc_D[row + i] * change * change;
    if (i == 0) continue;
    const double from = start * contact.friction[i - 1], by = change * contact.friction[i - 1];
    cone.tangent += from * from;
    cone.tangent_mixed += from * by;
    cone.tangent_change += by * by;
  }
  cone.stiffness = data.efc_D[row] / (mu * mu * (1 + mu * mu));
  return cone;
}

void add_cone(const Cone& cone, double at, Slope& sum) {
  const double mu = cone.friction;
  const double normal = cone.normal + at * cone.normal_change;
  const double square = std::max(0.0, cone.tangent + at * (2 * cone.tangent_mixed + at * cone.tangent_change));
  if (normal >= 0 && normal * normal >= cone.friction_square * square) return;  // apart
  if (normal <= 0 && square <= cone.friction_square * normal * normal) {        // sticks
    sum.first += cone.slope + at * cone.curvature;
    sum.second += cone.curvature;
    return;
  }
  const double tangent = std::sqrt(square), inverse = 1 / tangent;
  const double first = (cone.tangent_mixed + at * cone.tangent_change) * inverse;
  const double second = (cone.tangent_change - first * first) * inverse;
  const double depth = normal - mu * tangent, change = cone.normal_change - mu * first;
  sum.first += cone.stiffness * depth * change;
  sum.second += cone.stiffness * (change * change - depth * mu * second);
}

// The lanes' sums are added in one order, whatever the processor adds at a time.
void add_springs(const Springs& springs, double at, Slope& sum) {
  Lanes first = {}, second = {};
  for (int i = 0; i < springs.count; i += kLanes) {
    Lanes start, change, weight, low, high;
    read(springs.start + i, start);
    read(springs.change + i, change);
    read(springs.weight + i, weight);
    read(springs.low + i, low);
    read(springs.high + i, high);
    const Lanes value = start + at * change;
    Lanes bent = value < low ? low : value;
    bent = high < bent ? high : bent;
    first += weight * bent;
    second += bent == value ? weight * change : Lanes{};
  }
  sum.first += (first[0] + first[1]) + (first[2] + first[3]);
  sum.second += (second[0] + second[1]) + (second[2] + second[3]);
}

Slope slope_at(const Line& line, const Terms& terms, double at) {
  Slope sum{line.slope + at * line.curvature, line.curvature};
  add_springs(terms.springs, at, sum);
  for (int i = 0; i < terms.count; ++i) add_cone(terms.cones[i], at, sum);
  return sum;
}

// Rows [first, end).
void add_springs_of(const mjData& data, const Line& line, int first, int end, const Springs& springs) {
  const double *stiffness = data.efc_D, *resistance = data.efc_R, *loss = data.efc_frictionloss;
  const int rubbing = std::max(first, data.ne), pushing = std::max(first, data.ne + data.nf);
  const int at = springs.count - first;
  for (int row = first; row < end; ++row) {
    springs.start[at + row] = line.start[row];
    springs.change[at + row] = line.direction[row];
    springs.weight[at + row] = stiffness[row] * line.direction[row];
    springs.low[at + row] = -kInfinity;
  }
  for (int row = first; row < std::min(end, rubbing); ++row) springs.high[at + row] = kInfinity;
  for (int row = rubbing; row < std::min(end, pushing); ++row) {
    springs.high[at + row] = resistance[row] * loss[row];
    springs.low[at + row] = -springs.high[at + row];
  }
  for (int row = pushing; row < end; ++row) springs.high[at + row] = 0;
}

Terms prepare(mjData& data, const Line& line) {
  const int room = data.nefc + kLanes;
  Springs springs = {0,
                     take<double>(data, room),
                     take<double>(data, room),
                     take<double>(data, room),
                     take<double>(data, room),
                     take<double>(data, room)};
  Cone* cones = take<Cone>(data, data.ncon);
  int count = 0;
  for (int row = 0; row < data.nefc;) {
    const int first = row;
    while (row < data.nefc && data.efc_type[row] != mjCNSTR_CONTACT_ELLIPTIC) ++row;
    add_springs_of(data, line, first, row, springs);
    springs.count += row - first;
    for (; row < data.nefc && data.efc_type[row] == mjCNSTR_CONTACT_ELLIPTIC;) {
      cones[count++] = cone_of(data, line, row);
      row += data.contact[data.efc_id[row]].dim;
    }
  }
  for (; springs.count % kLanes != 0; ++springs.count) {
    for (double* numbers : {springs.start, springs.change, springs.low, springs.high, springs.weight}) {
      numbers[springs.count] = 0;
    }
  }
  return {springs, count, cones};
}

// The search along a line ends at this part of the slope that ends the whole, as in MuJoCo.
constexpr double kLineTolerance = 0.01;

struct Matrices {
  Blocks blocks;
  Hessian hessian;
};

// What the search keeps besides data.qacc, which it moves.
struct Search {
  double* momentum;   // M qacc
  double* violation;  // J qacc - aref
  double* direction;
  double* momentum_change;   // M direction
  double* violation_change;  // J direction
  double cost;               // Gauss's principle: half the square of M (qacc - qacc_smooth), and the constraints' part
};

void update_products(const mjData& data, const Matrices& matrices, Search& search) {
  multiply_inertia(matrices.hessian, data.qacc, search.momentum);
  multiply(matrices.blocks, data.qacc, search.violation);
  mju_subFrom(search.violation, data.efc_aref, data.nefc);
}

// Forces, states and cost for where the search is.
void update_constraints(mjData& data, const Matrices& matrices, Search& search) {
  const int size = matrices.hessian.size;
  search.cost = update_states(data, matrices.blocks, search.violation);
  multiply_transposed(matrices.blocks, data.efc_force, size, data.qfrc_constraint);
  for (int i = 0; i < size; ++i) {
    search.cost += 0.5 * (search.momentum[i] - data.qfrc_smooth[i]) * (data.qacc[i] - data.qacc_smooth[i]);
  }
}

// Starts from the last step's accelerations, or from those without constraints where these cost less.
void choose_start(const mjModel& model, mjData& data, const Matrices& matrices, Search& search) {
  const double cold = cost_of(data, matrices.blocks, data.efc_b);  // the part without constraints is then zero
  const bool may_warm = (model.opt.disableflags & mjDSBL_WARMSTART) == 0;
  mju_copy(data.qacc, may_warm ? data.qacc_warmstart : data.qacc_smooth, model.nv);
  update_products(data, matrices, search);
  update_constraints(data, matrices, search);
  if (!(search.cost > cold)) return;
  mju_copy(data.qacc, data.qacc_smooth, model.nv);
  update_products(data, matrices, search);
  update_constraints(data, matrices, search);
}

// Points the direction down the slope of the cost, and returns how steep that is. `solve` turns it to Newton's.
double descend(const mjModel& model, const mjData& data, const Search& search) {
  for (int i = 0; i < model.nv; ++i) {
    search.direction[i] = data.qfrc_smooth[i] + data.qfrc_constraint[i] - search.momentum[i];
  }
  return mju_norm(search.direction, model.nv);
}

// Goes along the direction as far as the cost falls. False if it does not.
bool advance(const mjModel& model, mjData& data, const Matrices& matrices, Search& search, double scale) {
  const double length = mju_norm(search.direction, model.nv);
  if (length < mjMINVAL) return false;
  multiply_inertia(matrices.hessian, search.direction, search.momentum_change);
  multiply(matrices.blocks, search.direction, search.violation_change);
  const Line line = {
      search.violation, search.violation_change,
      mju_dot(search.direction, search.momentum, model.nv) - mju_dot(search.direction, data.qfrc_smooth, model.nv),
      mju_dot(search.direction, search.momentum_change, model.nv)};
  const double tolerance = model.opt.tolerance * kLineTolerance * length / scale;
  const double distance = find_least(data, line, tolerance);
  if (distance == 0) return false;
  mju_addToScl(data.qacc, search.direction, distance, model.nv);
  mju_addToScl(search.momentum, search.momentum_change, distance, model.nv);
  mju_addToScl(search.violation, search.violation_change, distance, data.nefc);
  return true;
}

// Newton's method: each direction is the one that leads to the least cost if the states of constraints stay.
void minimize(const mjModel& model, mjData& data, Matrices& matrices, Search& search) {
  const double scale = 1 / (model.stat.meaninertia * model.nv);
  descend(model, data, search);
  int& iterations = compat::iterations(data);
  while (iterations < model.opt.iterations) {
    factorize(matrices.hessian, data, matrices.blocks, search.violation);
    solve(matrices.hessian, search.direction);
    if (!advance(model, data, matrices, search, scale)) return;
    ++iterations;
    const double before = search.cost;
    update_constraints(data, matrices, search);
    const double slope = scale * descend(model, data, search);
    if (scale * (before - search.cost) < model.opt.tolerance || slope < model.opt.tolerance) return;
  }
}

Matrices make_matrices(const mjModel& model, mjData& data) {
  const Blocks blocks = gather_blocks(data);
  return {blocks, make_hessian(model, data, blocks)};
}

void solve_constraints(const mjModel& model, mjData& data) {
  const compat::StackMark stack = compat::mark_stack(data);
  compat::iterations(data) = 0;
  compat::entries(data) = 0;
  if (data.nefc == 0) {
    mju_copy(data.qacc, data.qacc_smooth, model.nv);
    mju_zero(data.qfrc_constraint, model.nv);
  } else {
    Matrices matrices = make_matrices(model, data);
    compat::entries(data) = matrices.hessian.entries;
    multiply(matrices.blocks, data.qacc_smooth, data.efc_b);
    mju_subFrom(data.efc_b, data.efc_aref, data.nefc);
    Search search = {take<double>(data, model.nv), take<double>(data, data.nefc), take<double>(data, model.nv),
                     take<double>(data, model.nv), take<double>(data, data.nefc), 0};
    choose_start(model, data, matrices, search);
    minimize(model, data, matrices, search);
  }
  mju_copy(data.qacc_warmstart, data.qacc, model.nv);
  compat::release_stack(data, stack);
}

#if MIMO_MUJOCO_4
void begin_step(const mjModel& model, mjData& data) { mj_step1(&model, &data); }
#else
// mj_step1 with our own search for contacts. It calls neither mjcb_control nor mjcb_contactfilter: while a host has set
// one of them, Physics takes no step (engine/callbacks.h).
void begin_step(const mjModel& model, mjData& data) {
  mj_checkPos(&model, &data);
  mj_checkVel(&model, &data);
  update_poses(model, data);
  mj_camlight(&model, &data);
  mj_tendon(&model, &data);
  update_inertia(model, data);
  collide(model, data);
  make_constraints(model, data);
  mj_transmission(&model, &data);
  mj_sensorPos(&model, &data);
  mj_energyPos(&model, &data);
  update_velocities(model, data);
  mj_sensorVel(&model, &data);
  mj_energyVel(&model, &data);
}
#endif

}  // namespace

// The slope grows along the line, so a place where it is negative and one where it is positive hold the least between
// them. Newton's steps lead there. Halves are taken where such a step leads out, and where steps do not get shorter
// quickly: the slope of a cone is shaped like an S, and they can bounce from one end of it to the other for ever.
MIMO_ALSO_FOR_AVX2
double find_least(mjData& data, const Line& line, double tolerance) {
  const compat::StackMark stack = compat::mark_stack(data);
  const Terms terms = prepare(data, line);
  double low = 0, high = kInfinity, at = 0, moved = kInfinity;
  double best = 0, flattest = kInfinity;  // rounding may end the search where the slope is not within the tolerance
  Slope slope = slope_at(line, terms, at);
  for (int i = 1; i < kMostEvaluations && slope.first != 0; ++i) {
    double next = at - slope.first / slope.second;
    const bool slow = high < kInfinity && std::abs(next - at) > 0.5 * moved;
    if (slow || next <= low || next >= high) next = 0.5 * (low + high);
    if (next == low || next == high) break;  // there is no number between
    moved = std::abs(next - at);
    at = next;
    slope = slope_at(line, terms, at);
    // What is no number goes on to mj_checkAcc, which knows what to do with it.
    if (!(std::abs(slope.first) >= flattest)) {
      flattest = std::abs(slope.first);
      best = at;
    }
    if (!(std::abs(slope.first) >= tolerance)) break;
    (slope.first < 0 ? low : high) = at;
  }
  compat::release_stack(data, stack);
  return best;
}

bool newton_step_serves(const mjModel& model) {
  const mjOption& opt = model.opt;
  return model.nv > 0 && mj_isSparse(&model) && opt.solver == mjSOL_NEWTON && opt.integrator == mjINT_EULER &&
         opt.noslip_iterations == 0 && (opt.enableflags & mjENBL_FWDINV) == 0;
}

void newton_step(const mjModel* model, mjData* data) {
  begin_step(*model, *data);
  actuate(*model, *data);
  mj_fwdAcceleration(model, data);
  solve_constraints(*model, *data);
  compat::expect_accelerations(*data);
  mj_sensorAcc(model, data);
  mj_checkAcc(model, data);
  integrate(*model, *data);
}

}  // namespace mimo::solver
