#include "solver/newton.h"

#include "solver/collision.h"
#include "solver/constraint_states.h"
#include "solver/hessian.h"
#include "solver/inertia.h"
#include "solver/line_search.h"
#include "solver/stack.h"

namespace mimo::solver {
namespace {

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
  mj_kinematics(&model, &data);
  mj_comPos(&model, &data);
  mj_camlight(&model, &data);
  mj_tendon(&model, &data);
  update_inertia(model, data);
  collide(model, data);
  mj_makeConstraint(&model, &data);
  mj_transmission(&model, &data);
  mj_sensorPos(&model, &data);
  mj_energyPos(&model, &data);
  mj_fwdVelocity(&model, &data);
  mj_sensorVel(&model, &data);
  mj_energyVel(&model, &data);
}
#endif

}  // namespace

bool newton_step_serves(const mjModel& model) {
  const mjOption& opt = model.opt;
  return model.nv > 0 && mj_isSparse(&model) && opt.solver == mjSOL_NEWTON && opt.integrator == mjINT_EULER &&
         opt.noslip_iterations == 0 && (opt.enableflags & mjENBL_FWDINV) == 0;
}

void newton_step(const mjModel* model, mjData* data) {
  begin_step(*model, *data);
  mj_fwdActuation(model, data);
  mj_fwdAcceleration(model, data);
  solve_constraints(*model, *data);
  compat::expect_accelerations(*data);
  mj_sensorAcc(model, data);
  mj_checkAcc(model, data);
  integrate(*model, *data);
}

}  // namespace mimo::solver
