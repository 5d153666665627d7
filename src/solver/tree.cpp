#include "solver/tree.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include "compat/mujoco.h"
#include "solver/constraints.h"

namespace mimo::solver {

#if MIMO_MUJOCO_4

void actuate(const mjModel& model, mjData& data) { mj_fwdActuation(&model, &data); }

#else

namespace {

void copy3(const double* from, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

void turn_by_matrix(const double* m, const double* v, double* turned) {
  turned[0] = m[0] * v[0] + m[1] * v[1] + m[2] * v[2];
  turned[1] = m[3] * v[0] + m[4] * v[1] + m[5] * v[2];
  turned[2] = m[6] * v[0] + m[7] * v[1] + m[8] * v[2];
}

bool is_no_turn(const double* q) { return q[0] == 1 && q[1] == 0 && q[2] == 0 && q[3] == 0; }

void turn_by_quaternion(const double* q, const double* v, double* turned) {
  if (is_no_turn(q)) return copy3(v, turned);
  const double x = q[0] * v[0] + q[2] * v[2] - q[3] * v[1];
  const double y = q[0] * v[1] + q[3] * v[0] - q[1] * v[2];
  const double z = q[0] * v[2] + q[1] * v[1] - q[2] * v[0];
  turned[0] = v[0] + 2 * (q[2] * z - q[3] * y);
  turned[1] = v[1] + 2 * (q[3] * x - q[1] * z);
  turned[2] = v[2] + 2 * (q[1] * y - q[2] * x);
}

// First b, then a.
void join_turns(const double* a, const double* b, double* both) {
  both[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  both[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  both[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  both[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

void matrix_of(const double* q, double* m) {
  if (is_no_turn(q)) {
    std::fill_n(m, 9, 0.0);
    m[0] = m[4] = m[8] = 1;
    return;
  }
  const double q00 = q[0] * q[0], q01 = q[0] * q[1], q02 = q[0] * q[2], q03 = q[0] * q[3];
  const double q11 = q[1] * q[1], q12 = q[1] * q[2], q13 = q[1] * q[3];
  const double q22 = q[2] * q[2], q23 = q[2] * q[3], q33 = q[3] * q[3];
  m[0] = q00 + q11 - q22 - q33;
  m[1] = 2 * (q12 - q03);
  m[2] = 2 * (q13 + q02);
  m[3] = 2 * (q12 + q03);
  m[4] = q00 - q11 + q22 - q33;
  m[5] = 2 * (q23 - q01);
  m[6] = 2 * (q13 - q02);
  m[7] = 2 * (q23 + q01);
  m[8] = q00 - q11 - q22 + q33;
}

void cross(const double* a, const double* b, double* product) {
  product[0] = a[1] * b[2] - a[2] * b[1];
  product[1] = a[2] * b[0] - a[0] * b[2];
  product[2] = a[0] * b[1] - a[1] * b[0];
}

// Moves a body's frame by one of its joints, and notes where that joint is.
void move_by_joint(const mjModel& model, mjData& data, int joint, double* position, double* turn) {
  double *axis = data.xaxis + 3 * joint, *anchor = data.xanchor + 3 * joint;
  const double *own_axis = model.jnt_axis + 3 * joint, *own_anchor = model.jnt_pos + 3 * joint;
  const int address = model.jnt_qposadr[joint], type = model.jnt_type[joint];
  turn_by_quaternion(turn, own_axis, axis);
  turn_by_quaternion(turn, own_anchor, anchor);
  for (int i = 0; i < 3; ++i) anchor[i] += position[i];
  if (type == mjJNT_SLIDE) {
    const double way = data.qpos[address] - model.qpos0[address];
    for (int i = 0; i < 3; ++i) position[i] += axis[i] * way;
    return;
  }
  double by[4], turned[4], lever[3];
  if (type == mjJNT_BALL) {
    std::copy_n(data.qpos + address, 4, by);
  } else {
    mju_axisAngle2Quat(by, own_axis, data.qpos[address] - model.qpos0[address]);  // with MuJoCo's sine and cosine
  }
  join_turns(turn, by, turned);
  std::copy_n(turned, 4, turn);
  turn_by_quaternion(turn, own_anchor, lever);
  for (int i = 0; i < 3; ++i) position[i] += (anchor[i] - position[i]) - lever[i];
}

void place_body(const mjModel& model, mjData& data, int body) {
  const int first = model.body_jntadr[body], joints = model.body_jntnum[body];
  double *position = data.xpos + 3 * body, *turn = data.xquat + 4 * body;
  if (joints == 1 && model.jnt_type[first] == mjJNT_FREE) {
    const double* state = data.qpos + model.jnt_qposadr[first];
    copy3(state, position);
    std::copy_n(state + 3, 4, turn);
    copy3(position, data.xanchor + 3 * first);
    data.xaxis[3 * first] = data.xaxis[3 * first + 1] = 0;
    data.xaxis[3 * first + 2] = 1;
  } else {
    const int parent = model.body_parentid[body], mocap = model.body_mocapid[body];
    const double* own_position = mocap >= 0 ? data.mocap_pos + 3 * mocap : model.body_pos + 3 * body;
    const double* own_turn = mocap >= 0 ? data.mocap_quat + 4 * mocap : model.body_quat + 4 * body;
    turn_by_matrix(data.xmat + 9 * parent, own_position, position);
    for (int i = 0; i < 3; ++i) position[i] = data.xpos[3 * parent + i] + position[i];
    join_turns(data.xquat + 4 * parent, own_turn, turn);
    for (int joint = first; joint < first + joints; ++joint) move_by_joint(model, data, joint, position, turn);
  }
  mju_normalize4(turn);
  matrix_of(turn, data.xmat + 9 * body);
}

// What is fixed on a body: in a frame of its own (0), or in that of the body (1) or of its inertia (2).
void place_fixed(const mjData& data, int body, int frame, const double* own_position, const double* own_turn,
                 double* position, double* matrix) {
  if (frame != 0) {
    copy3((frame == 1 ? data.xpos : data.xipos) + 3 * body, position);
    std::copy_n((frame == 1 ? data.xmat : data.ximat) + 9 * body, 9, matrix);
    return;
  }
  turn_by_matrix(data.xmat + 9 * body, own_position, position);
  for (int i = 0; i < 3; ++i) position[i] += data.xpos[3 * body + i];
  double turn[4];
  join_turns(data.xquat + 4 * body, own_turn, turn);
  matrix_of(turn, matrix);
}

void place_world(mjData& data) {
  std::fill_n(data.xpos, 3, 0.0);
  std::fill_n(data.xipos, 3, 0.0);
  std::fill_n(data.xquat, 4, 0.0);
  data.xquat[0] = 1;
  matrix_of(data.xquat, data.xmat);
  matrix_of(data.xquat, data.ximat);
}

// mj_kinematics.
void place_all(const mjModel& model, mjData& data) {
  place_world(data);
  mj_normalizeQuat(&model, data.qpos);
  for (int i = 0; i < model.nmocap; ++i) mju_normalize4(data.mocap_quat + 4 * i);
  for (int body = 1; body < model.nbody; ++body) place_body(model, data, body);
  for (int body = 1; body < model.nbody; ++body) {
    place_fixed(data, body, model.body_sameframe[body], model.body_ipos + 3 * body, model.body_iquat + 4 * body,
                data.xipos + 3 * body, data.ximat + 9 * body);
  }
  for (int i = 0; i < model.ngeom; ++i) {
    place_fixed(data, model.geom_bodyid[i], model.geom_sameframe[i], model.geom_pos + 3 * i, model.geom_quat + 4 * i,
                data.geom_xpos + 3 * i, data.geom_xmat + 9 * i);
  }
  for (int i = 0; i < model.nsite; ++i) {
    place_fixed(data, model.site_bodyid[i], model.site_sameframe[i], model.site_pos + 3 * i, model.site_quat + 4 * i,
                data.site_xpos + 3 * i, data.site_xmat + 9 * i);
  }
}

// The centre of mass of each body with all that hangs on it.
void find_centers(const mjModel& model, mjData& data) {
  const compat::StackMark stack = compat::mark_stack(data);
  double* masses = take<double>(data, model.nbody);
  std::fill_n(masses, model.nbody, 0.0);
  std::fill_n(data.subtree_com, 3 * model.nbody, 0.0);
  for (int body = model.nbody - 1; body >= 0; --body) {
    double* center = data.subtree_com + 3 * body;
    const double *own = data.xipos + 3 * body, mass = model.body_mass[body];
    for (int i = 0; i < 3; ++i) center[i] += own[i] * mass;
    masses[body] += mass;
    if (body > 0) {
      const int parent = model.body_parentid[body];
      for (int i = 0; i < 3; ++i) data.subtree_com[3 * parent + i] += center[i];
      masses[parent] += masses[body];
    }
    if (masses[body] < mjMINVAL) {
      copy3(own, center);
    } else {
      const double share = 1.0 / std::max(mjMINVAL, masses[body]);
      for (int i = 0; i < 3; ++i) center[i] *= share;
    }
  }
  compat::release_stack(data, stack);
}

// A body's inertia around the centre of its tree.
void move_inertia(const double* principal, const double* m, const double* offset, double mass, double* inertia) {
  double scaled[9];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) scaled[3 * i + k] = m[3 * k + i] * principal[i];
  }
  const auto entry = [&](int row, int column) {
    return m[3 * row] * scaled[column] + m[3 * row + 1] * scaled[3 + column] + m[3 * row + 2] * scaled[6 + column];
  };
  const double *d = offset, xx = d[0] * d[0], yy = d[1] * d[1], zz = d[2] * d[2];
  inertia[0] = entry(0, 0) + mass * (yy + zz);
  inertia[1] = entry(1, 1) + mass * (xx + zz);
  inertia[2] = entry(2, 2) + mass * (xx + yy);
  inertia[3] = entry(0, 1) - mass * d[0] * d[1];
  inertia[4] = entry(0, 2) - mass * d[0] * d[2];
  inertia[5] = entry(1, 2) - mass * d[1] * d[2];
  for (int i = 0; i < 3; ++i) inertia[6 + i] = mass * d[i];
  inertia[9] = mass;
}

// How a turn around an axis moves the centre of the tree, which lies at this offset from it.
void write_turn(const double* axis, const double* offset, double* motion) {
  copy3(axis, motion);
  cross(axis, offset, motion + 3);
}

void write_motions(const mjModel& model, mjData& data, int joint) {
  const int body = model.jnt_bodyid[joint], type = model.jnt_type[joint];
  double* motion = data.cdof + 6 * model.jnt_dofadr[joint];
  double offset[3];
  for (int i = 0; i < 3; ++i) {
    offset[i] = data.subtree_com[3 * model.body_rootid[body] + i] - data.xanchor[3 * joint + i];
  }
  if (type == mjJNT_HINGE) return write_turn(data.xaxis + 3 * joint, offset, motion);
  if (type == mjJNT_SLIDE) {
    std::fill_n(motion, 3, 0.0);
    return copy3(data.xaxis + 3 * joint, motion + 3);
  }
  if (type == mjJNT_FREE) {
    std::fill_n(motion, 18, 0.0);
    for (int i = 0; i < 3; ++i) motion[3 + 7 * i] = 1;
    motion += 18;
  }
  const double* m = data.xmat + 9 * body;
  for (int i = 0; i < 3; ++i) {
    const double axis[] = {m[i], m[3 + i], m[6 + i]};
    write_turn(axis, offset, motion + 6 * i);
  }
}

// As mju_mulDofVec: what these degrees of freedom do at these speeds.
void sum_motions(const double* motions, const double* speeds, int count, double* sum) {
  if (count == 1) {
    for (int i = 0; i < 6; ++i) sum[i] = motions[i] * speeds[0];
    return;
  }
  std::fill_n(sum, 6, 0.0);
  for (int k = 0; k < count; ++k) {
    if (speeds[k] == 0) continue;
    for (int i = 0; i < 6; ++i) sum[i] += motions[6 * k + i] * speeds[k];
  }
}

void cross_motion(const double* velocity, const double* v, double* product) {
  const double* w = velocity;
  product[0] = -w[2] * v[1] + w[1] * v[2];
  product[1] = w[2] * v[0] - w[0] * v[2];
  product[2] = -w[1] * v[0] + w[0] * v[1];
  product[3] = (-w[2] * v[4] + w[1] * v[5]) + (-w[5] * v[1] + w[4] * v[2]);
  product[4] = (w[2] * v[3] - w[0] * v[5]) + (w[5] * v[0] - w[3] * v[2]);
  product[5] = (-w[1] * v[3] + w[0] * v[4]) + (-w[4] * v[0] + w[3] * v[1]);
}

void add_cross_force(const double* velocity, const double* f, double* sum) {
  const double* w = velocity;
  sum[0] += (-w[2] * f[1] + w[1] * f[2]) + (-w[5] * f[4] + w[4] * f[5]);
  sum[1] += (w[2] * f[0] - w[0] * f[2]) + (w[5] * f[3] - w[3] * f[5]);
  sum[2] += (-w[1] * f[0] + w[0] * f[1]) + (-w[4] * f[3] + w[3] * f[4]);
  sum[3] += -w[2] * f[4] + w[1] * f[5];
  sum[4] += w[2] * f[3] - w[0] * f[5];
  sum[5] += -w[1] * f[3] + w[0] * f[4];
}

void add6(const double* numbers, double* sums) {
  for (int i = 0; i < 6; ++i) sums[i] += numbers[i];
}

// mj_comVel: velocities of bodies, and how motions change by them.
void move_bodies(const mjModel& model, mjData& data) {
  std::fill_n(data.cvel, 6, 0.0);
  for (int body = 1; body < model.nbody; ++body) {
    double* velocity = data.cvel + 6 * body;
    std::copy_n(data.cvel + 6 * model.body_parentid[body], 6, velocity);
    const int end = model.body_dofadr[body] + model.body_dofnum[body];
    for (int dof = model.body_dofadr[body]; dof < end;) {
      const int type = model.jnt_type[model.dof_jntid[dof]], first = model.jnt_dofadr[model.dof_jntid[dof]];
      const bool slides = type == mjJNT_FREE && dof == first;  // its turns come next
      const int count = type == mjJNT_FREE || type == mjJNT_BALL ? 3 : 1;
      double change[6];
      sum_motions(data.cdof + 6 * dof, data.qvel + dof, count, change);
      for (int i = dof; i < dof + count; ++i) {
        if (slides) {
          std::fill_n(data.cdof_dot + 6 * i, 6, 0.0);
        } else {
          cross_motion(velocity, data.cdof + 6 * i, data.cdof_dot + 6 * i);
        }
      }
      add6(change, velocity);
      dof += count;
    }
  }
}

// mj_rne without accelerations: what gravity and velocities cost.
void find_bias(const mjModel& model, mjData& data) {
  const compat::StackMark stack = compat::mark_stack(data);
  double *accelerations = take<double>(data, 6 * model.nbody), *forces = take<double>(data, 6 * model.nbody);
  std::fill_n(accelerations, 6, 0.0);
  if ((model.opt.disableflags & mjDSBL_GRAVITY) == 0) {
    for (int i = 0; i < 3; ++i) accelerations[3 + i] = model.opt.gravity[i] * -1;
  }
  for (int body = 1; body < model.nbody; ++body) {
    double *acceleration = accelerations + 6 * body, *force = forces + 6 * body;
    const double *above = accelerations + 6 * model.body_parentid[body], *velocity = data.cvel + 6 * body;
    double change[6], momentum[6];
    const int count = model.body_dofnum[body], first = count > 0 ? model.body_dofadr[body] : 0;
    sum_motions(data.cdof_dot + 6 * first, data.qvel + first, count, change);
    for (int i = 0; i < 6; ++i) acceleration[i] = above[i] + change[i];
    momentum_of(data.cinert + 10 * body, acceleration, force);
    momentum_of(data.cinert + 10 * body, velocity, momentum);
    add_cross_force(velocity, momentum, force);
  }
  std::fill_n(forces, 6, 0.0);
  for (int body = model.nbody - 1; body > 0; --body) {
    if (model.body_parentid[body] != 0) add6(forces + 6 * body, forces + 6 * model.body_parentid[body]);
  }
  for (int dof = 0; dof < model.nv; ++dof) {
    data.qfrc_bias[dof] = dot6(data.cdof + 6 * dof, forces + 6 * model.dof_bodyid[dof]);
  }
  compat::release_stack(data, stack);
}

// Of tendons that are the sum of a few joints: builds of MuJoCo add more in different orders. False if one is longer.
bool find_tendon_velocities(const mjModel& model, mjData& data) {
  for (int tendon = 0; tendon < model.ntendon; ++tendon) {
    const int first = data.ten_J_rowadr[tendon], count = data.ten_J_rownnz[tendon];
    if (count > 3) return false;
    double sum = 0;
    for (int at = first; at < first + count; ++at) sum += data.ten_J[at] * data.qvel[data.ten_J_colind[at]];
    data.ten_velocity[tendon] = sum;
  }
  return true;
}

// A motor that acts on one degree of freedom only, so that all others of its row of moments are zero; -1 for others.
int dof_of_motor(const mjModel& model, int motor) {
  const int kind = model.actuator_trntype[motor];
  if (kind != mjTRN_JOINT && kind != mjTRN_JOINTINPARENT) return -1;
  const int joint = model.actuator_trnid[2 * motor], type = model.jnt_type[joint];
  return type == mjJNT_HINGE || type == mjJNT_SLIDE ? model.jnt_dofadr[joint] : -1;
}

void find_motor_velocities(const mjModel& model, mjData& data) {
  for (int i = 0; i < model.nu; ++i) {
    const double* moments = data.actuator_moment + i * model.nv;
    const int dof = dof_of_motor(model, i);
    data.actuator_velocity[i] = dof < 0 ? mju_dot(moments, data.qvel, model.nv) : 0.0 + moments[dof] * data.qvel[dof];
  }
}

// Forces that are their control times a number, without a state.
bool is_plain(const mjModel& model, int motor) {
  return model.actuator_gaintype[motor] == mjGAIN_FIXED && model.actuator_biastype[motor] == mjBIAS_NONE &&
         model.actuator_dyntype[motor] == mjDYN_NONE && dof_of_motor(model, motor) >= 0;
}

bool all_plain(const mjModel& model) {
  for (int i = 0; i < model.nu; ++i) {
    if (!is_plain(model, i)) return false;
  }
  return true;
}

// What is no number stays none.
double clipped(bool limited, double value, const double* range) {
  if (!limited) return value;
  return value < range[0] ? range[0] : value > range[1] ? range[1] : value;
}

}  // namespace

MIMO_ALSO_FOR_AVX2
void update_poses(const mjModel& model, mjData& data) {
  place_all(model, data);
  find_centers(model, data);
  for (int body = 1; body < model.nbody; ++body) {
    double offset[3];
    for (int i = 0; i < 3; ++i) {
      offset[i] = data.xipos[3 * body + i] - data.subtree_com[3 * model.body_rootid[body] + i];
    }
    move_inertia(model.body_inertia + 3 * body, data.ximat + 9 * body, offset, model.body_mass[body],
                 data.cinert + 10 * body);
  }
  for (int joint = 0; joint < model.njnt; ++joint) write_motions(model, data, joint);
}

MIMO_ALSO_FOR_AVX2
void update_velocities(const mjModel& model, mjData& data) {
  if (!find_tendon_velocities(model, data)) return mj_fwdVelocity(&model, &data);
  find_motor_velocities(model, data);
  move_bodies(model, data);
  mj_passive(&model, &data);
  mj_referenceConstraint(&model, &data);
  find_bias(model, data);
}

void actuate(const mjModel& model, mjData& data) {
  const bool off = (model.opt.disableflags & mjDSBL_ACTUATION) != 0;
  if (off || !all_plain(model)) return mj_fwdActuation(&model, &data);
  const bool clips = (model.opt.disableflags & mjDSBL_CLAMPCTRL) == 0;
  double* forces = data.actuator_force;
  for (int i = 0; i < model.nu; ++i) {
    forces[i] = clipped(clips && model.actuator_ctrllimited[i] != 0, data.ctrl[i], model.actuator_ctrlrange + 2 * i);
  }
  const double* bad = std::find_if(forces, forces + model.nu, [](double x) { return mju_isBad(x) != 0; });
  if (bad != forces + model.nu) {
    mj_warning(&data, mjWARN_BADCTRL, static_cast<int>(bad - forces));
    std::fill_n(forces, model.nu, 0.0);
  }
  std::fill_n(data.qfrc_actuator, model.nv, 0.0);
  for (int i = 0; i < model.nu; ++i) {
    const double force = model.actuator_gainprm[mjNGAIN * i] * forces[i] + 0.0;  // plus no bias
    forces[i] = clipped(model.actuator_forcelimited[i] != 0, force, model.actuator_forcerange + 2 * i);
    const int dof = dof_of_motor(model, i);
    data.qfrc_actuator[dof] += data.actuator_moment[i * model.nv + dof] * forces[i];
  }
}

#endif

}  // namespace mimo::solver
