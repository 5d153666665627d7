#include "solver/inertia.h"

#include <mujoco/mujoco.h>

#include <algorithm>

#include "solver/stack.h"

namespace mimo::solver {

#if MIMO_MUJOCO_4

void integrate(const mjModel& model, mjData& data) { mj_Euler(&model, &data); }

#else

namespace {

// In the order of mju_dot.
double dot(const double* a, const double* b) {
  return (a[0] * b[0] + a[2] * b[2]) + (a[1] * b[1] + a[3] * b[3]) + (a[4] * b[4] + a[5] * b[5]);
}

// The momentum of a body of this inertia (10 numbers, as mjData.crb) at this velocity.
void momentum_of(const double* inertia, const double* velocity, double* momentum) {
  const double *i = inertia, *v = velocity;
  momentum[0] = i[0] * v[0] + i[3] * v[1] + i[4] * v[2] - i[8] * v[4] + i[7] * v[5];
  momentum[1] = i[3] * v[0] + i[1] * v[1] + i[5] * v[2] + i[8] * v[3] - i[6] * v[5];
  momentum[2] = i[4] * v[0] + i[5] * v[1] + i[2] * v[2] - i[7] * v[3] + i[6] * v[4];
  momentum[3] = i[8] * v[1] - i[7] * v[2] + i[9] * v[3];
  momentum[4] = i[6] * v[2] - i[8] * v[0] + i[9] * v[4];
  momentum[5] = i[7] * v[0] - i[6] * v[1] + i[9] * v[5];
}

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
    for (int other = dof; other >= 0; other = model.dof_parentid[other]) *row++ += dot(data.cdof + 6 * other, momentum);
  }
}

// L'DL in the places of the matrix; rows are eliminated into those of the degrees of freedom that they hang on.
void factorize(const mjModel& model, mjData& data, double* factor, double* inverse) {
  for (int dof = model.nv - 1; dof >= 0; --dof) {
    double* row = factor + model.dof_Madr[dof];
    if (*row < mjMINVAL) {
      mj_warning(&data, mjWARN_INERTIA, dof);
      *row = mjMINVAL;
    }
    const double diagonal = *row++;
    inverse[dof] = 1.0 / diagonal;
    if (model.dof_simplenum[dof] != 0) continue;
    int above = 0;  // as many as the row has entries left
    for (int other = model.dof_parentid[dof]; other >= 0; other = model.dof_parentid[other]) ++above;
    for (int other = model.dof_parentid[dof]; other >= 0; other = model.dof_parentid[other], ++row, --above) {
      const double scale = *row / diagonal;
      double* __restrict to = factor + model.dof_Madr[other];
      for (int k = 0; k < above; ++k) to[k] += row[k] * -scale;
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

void update_inertia(const mjModel& model, mjData& data) {
  sum_inertias(model, data);
  fill_matrix(model, data);
  std::copy_n(data.qM, model.nM, data.qLD);
  factorize(model, data, data.qLD, data.qLDiagInv);
}

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

}  // namespace mimo::solver
