// Poses, velocities and forces of the tree of bodies, with the numbers of MuJoCo's own stages to the bit; faster,
// because MuJoCo 2.2.2 calls a function for each sum of three numbers. MuJoCo 4 does not, and keeps its stages.
#pragma once

#include <mujoco/mjdata.h>
#include <mujoco/mjmodel.h>

namespace mimo::solver {

// Six numbers each, as mju_dot adds their products.
inline double dot6(const double* a, const double* b) {
  return (a[0] * b[0] + a[2] * b[2]) + (a[1] * b[1] + a[3] * b[3]) + (a[4] * b[4] + a[5] * b[5]);
}

// The momentum of a body of this inertia (10 numbers, as mjData.crb) at this velocity.
inline void momentum_of(const double* inertia, const double* velocity, double* momentum) {
  const double *i = inertia, *v = velocity;
  momentum[0] = i[0] * v[0] + i[3] * v[1] + i[4] * v[2] - i[8] * v[4] + i[7] * v[5];
  momentum[1] = i[3] * v[0] + i[1] * v[1] + i[5] * v[2] + i[8] * v[3] - i[6] * v[5];
  momentum[2] = i[4] * v[0] + i[5] * v[1] + i[2] * v[2] - i[7] * v[3] + i[6] * v[4];
  momentum[3] = i[8] * v[1] - i[7] * v[2] + i[9] * v[3];
  momentum[4] = i[6] * v[2] - i[8] * v[0] + i[9] * v[4];
  momentum[5] = i[7] * v[0] - i[6] * v[1] + i[9] * v[5];
}

// mj_kinematics and mj_comPos.
void update_poses(const mjModel& model, mjData& data);

// mj_fwdVelocity.
void update_velocities(const mjModel& model, mjData& data);

// mj_fwdActuation.
void actuate(const mjModel& model, mjData& data);

}  // namespace mimo::solver
