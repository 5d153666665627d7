#include "solver/rows.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compat/mujoco.h"
#include "solver/constraints.h"

#if !MIMO_MUJOCO_4

namespace mimo::solver {
namespace {

bool is_on(const mjModel& model, int disabling) { return (model.opt.disableflags & disabling) == 0; }

bool has_equalities(const mjModel& model) {
  return is_on(model, mjDSBL_EQUALITY) &&
         std::any_of(model.eq_active, model.eq_active + model.neq, [](mjtByte active) { return active != 0; });
}

bool has_rubbing_tendons(const mjModel& model) {
  return std::any_of(model.tendon_frictionloss, model.tendon_frictionloss + model.ntendon,
                     [](double loss) { return loss > 0; });
}

// Their moments are made of the transposed Jacobian.
bool has_adhesion(const mjModel& model) {
  return std::any_of(model.actuator_trntype, model.actuator_trntype + model.nu,
                     [](int kind) { return kind == mjTRN_BODY; });
}

bool is_usual(const mjModel& model) {
  return model.opt.cone == mjCONE_ELLIPTIC && !has_rubbing_tendons(model) && !has_adhesion(model) &&
         !has_equalities(model);
}

// Rows with the same columns, which `columns` of the first one hold already. False where there is no room.
bool add_rows(const mjModel& model, mjData& data, int rows, int width, mjtConstraint type, int id) {
  const int first = data.nefc;
  if (first + rows > model.njmax) return false;
  for (int row = first; row < first + rows; ++row) {
    data.efc_J_rownnz[row] = width;
    data.efc_J_rowadr[row] = row == 0 ? 0 : data.efc_J_rowadr[row - 1] + data.efc_J_rownnz[row - 1];
    data.efc_J_rowsuper[row] = 0;
    data.efc_pos[row] = data.efc_margin[row] = data.efc_frictionloss[row] = 0;
    data.efc_type[row] = type;
    data.efc_id[row] = id;
  }
  data.nefc += rows;
  return true;
}

// A row of one column.
bool add_single(const mjModel& model, mjData& data, int dof, double value, mjtConstraint type, int id) {
  if (!add_rows(model, data, 1, 1, type, id)) return false;
  const int at = data.efc_J_rowadr[data.nefc - 1];
  data.efc_J_colind[at] = dof;
  data.efc_J[at] = value;
  return true;
}

bool add_frictions(const mjModel& model, mjData& data) {
  for (int dof = 0; dof < model.nv && is_on(model, mjDSBL_FRICTIONLOSS); ++dof) {
    if (!(model.dof_frictionloss[dof] > 0)) continue;
    if (!add_single(model, data, dof, 1, mjCNSTR_FRICTION_DOF, dof)) return false;
    data.efc_frictionloss[data.nefc - 1] = model.dof_frictionloss[dof];
  }
  data.nf = data.nefc;
  return true;
}

void place_limit(const mjModel& model, mjData& data, int joint, double distance) {
  data.efc_pos[data.nefc - 1] = distance;
  data.efc_margin[data.nefc - 1] = model.jnt_margin[joint];
}

bool add_limits_of_axis(const mjModel& model, mjData& data, int joint) {
  const double value = data.qpos[model.jnt_qposadr[joint]], *range = model.jnt_range + 2 * joint;
  for (const int side : {-1, 1}) {
    const double distance = side * (range[(side + 1) / 2] - value);
    if (!(distance < model.jnt_margin[joint])) continue;
    if (!add_single(model, data, model.jnt_dofadr[joint], -side, mjCNSTR_LIMIT_JOINT, joint)) return false;
    place_limit(model, data, joint, distance);
  }
  return true;
}

bool add_limit_of_ball(const mjModel& model, mjData& data, int joint) {
  double axis[3];
  mju_quat2Vel(axis, data.qpos + model.jnt_qposadr[joint], 1);
  const double value = mju_normalize3(axis);
  const double distance = std::max(model.jnt_range[2 * joint], model.jnt_range[2 * joint + 1]) - value;
  if (!(distance < model.jnt_margin[joint])) return true;
  if (!add_rows(model, data, 1, 3, mjCNSTR_LIMIT_JOINT, joint)) return false;
  const int at = data.efc_J_rowadr[data.nefc - 1];
  for (int i = 0; i < 3; ++i) {
    data.efc_J_colind[at + i] = model.jnt_dofadr[joint] + i;
    data.efc_J[at + i] = axis[i] * -1;
  }
  place_limit(model, data, joint, distance);
  return true;
}

bool add_limits_of_tendon(const mjModel& model, mjData& data, int tendon) {
  const double *range = model.tendon_range + 2 * tendon, margin = model.tendon_margin[tendon];
  const int from = data.ten_J_rowadr[tendon], width = data.ten_J_rownnz[tendon];
  for (const int side : {-1, 1}) {
    const double distance = side * (range[(side + 1) / 2] - data.ten_length[tendon]);
    if (!(distance < margin) || width == 0) continue;
    if (!add_rows(model, data, 1, width, mjCNSTR_LIMIT_TENDON, tendon)) return false;
    const int row = data.nefc - 1, at = data.efc_J_rowadr[row];
    for (int i = 0; i < width; ++i) {
      data.efc_J_colind[at + i] = data.ten_J_colind[from + i];
      data.efc_J[at + i] = data.ten_J[from + i] * -side;
    }
    data.efc_pos[row] = distance;
    data.efc_margin[row] = margin;
  }
  return true;
}

bool add_limits(const mjModel& model, mjData& data) {
  for (int joint = 0; joint < model.njnt && is_on(model, mjDSBL_LIMIT); ++joint) {
    if (model.jnt_limited[joint] == 0 || model.jnt_type[joint] == mjJNT_FREE) continue;
    const bool ball = model.jnt_type[joint] == mjJNT_BALL;
    if (!(ball ? add_limit_of_ball(model, data, joint) : add_limits_of_axis(model, data, joint))) return false;
  }
  for (int tendon = 0; tendon < model.ntendon && is_on(model, mjDSBL_LIMIT); ++tendon) {
    if (model.tendon_limited[tendon] != 0 && !add_limits_of_tendon(model, data, tendon)) return false;
  }
  return true;
}

// The last degree of freedom that moves a body; -1 for none.
int last_dof(const mjModel& model, int body) {
  while (body != 0 && model.body_dofnum[body] == 0) body = model.body_parentid[body];
  return body == 0 ? -1 : model.body_dofadr[body] + model.body_dofnum[body] - 1;
}

// What moves two bodies, ascending, and where each of both moves by it. Columns of what moves both alike hold zeros.
struct Chain {
  int count;
  int* dofs;  // descending
  bool* of_first;
  bool* of_second;
};

void merge(const mjModel& model, int first, int second, Chain& chain) {
  chain.count = 0;
  for (int one = last_dof(model, first), two = last_dof(model, second); one >= 0 || two >= 0;) {
    const int dof = std::max(one, two);
    chain.dofs[chain.count] = dof;
    chain.of_first[chain.count] = one == dof;
    chain.of_second[chain.count++] = two == dof;
    if (one == dof) one = model.dof_parentid[one];
    if (two == dof) two = model.dof_parentid[two];
  }
}

// How a point moves with a degree of freedom: its place from the centre of the tree.
void write_motion(const double* motion, const double* offset, double* moved) {
  const double *w = motion, *v = motion + 3;
  moved[0] = v[0] + (w[1] * offset[2] - w[2] * offset[1]);
  moved[1] = v[1] + (w[2] * offset[0] - w[0] * offset[2]);
  moved[2] = v[2] + (w[0] * offset[1] - w[1] * offset[0]);
}

// As mju_mulMatMat, which leaves out zeros.
double project(const double* axis, const double* vector) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum = axis[k] != 0 ? sum + vector[k] * axis[k] : sum;
  return sum;
}

void write_columns(const mjModel& model, mjData& data, const mjContact& contact, const Chain& chain) {
  const int start = data.efc_J_rowadr[contact.efc_address];
  double offset[2][3];
  for (int i = 0; i < 3; ++i) {
    offset[0][i] = contact.pos[i] - data.subtree_com[3 * model.body_rootid[model.geom_bodyid[contact.geom1]] + i];
    offset[1][i] = contact.pos[i] - data.subtree_com[3 * model.body_rootid[model.geom_bodyid[contact.geom2]] + i];
  }
  for (int k = 0; k < chain.count; ++k) {
    const int at = chain.count - 1 - k, dof = chain.dofs[k];
    const double* motion = data.cdof + 6 * dof;
    double moved[2][3] = {}, difference[6];
    if (chain.of_first[k]) write_motion(motion, offset[0], moved[0]);
    if (chain.of_second[k]) write_motion(motion, offset[1], moved[1]);
    for (int i = 0; i < 3; ++i) {
      difference[i] = moved[1][i] - moved[0][i];
      difference[3 + i] = (chain.of_second[k] ? motion[i] : 0) - (chain.of_first[k] ? motion[i] : 0);
    }
    double* values = data.efc_J + start + at;
    for (int r = 0; r < contact.dim; ++r) {
      data.efc_J_colind[start + r * chain.count + at] = dof;
      values[r * chain.count] = project(contact.frame + 3 * (r % 3), difference + (r < 3 ? 0 : 3));
    }
  }
}

bool add_contacts(const mjModel& model, mjData& data) {
  if (!is_on(model, mjDSBL_CONTACT) || data.ncon == 0) return true;
  const compat::StackMark stack = compat::mark_stack(data);
  Chain chain = {0, take<int>(data, model.nv), take<bool>(data, model.nv), take<bool>(data, model.nv)};
  bool room = true;
  for (int i = 0; i < data.ncon && room; ++i) {
    mjContact& contact = data.contact[i];
    if (contact.exclude != 0) continue;
    room = data.nefc + contact.dim <= model.njmax;  // also for one that moves nothing, as in MuJoCo
    if (!room) break;
    merge(model, model.geom_bodyid[contact.geom1], model.geom_bodyid[contact.geom2], chain);
    if (chain.count == 0) {
      contact.efc_address = -1;
      contact.exclude = 4;
      continue;
    }
    const int first = data.nefc;
    const mjtConstraint type = contact.dim == 1 ? mjCNSTR_CONTACT_FRICTIONLESS : mjCNSTR_CONTACT_ELLIPTIC;
    add_rows(model, data, contact.dim, chain.count, type, i);
    contact.efc_address = first;
    data.efc_pos[first] = contact.dist;
    data.efc_margin[first] = contact.includemargin;
    write_columns(model, data, contact, chain);
  }
  compat::release_stack(data, stack);
  return room;
}

// How hard and how fast a constraint is.
struct Softness {
  std::array<double, mjNREF> ref;
  std::array<double, mjNIMP> imp;
};

Softness softness_of(const mjModel& model, const double* ref, const double* imp) {
  Softness soft;
  std::copy_n(ref, mjNREF, soft.ref.begin());
  if ((ref[0] > 0) != (ref[1] > 0)) {
    mju_warning("mixed solref format, replacing with default");
    mj_defaultSolRefImp(soft.ref.data(), nullptr);
  }
  if (is_on(model, mjDSBL_REFSAFE) && soft.ref[0] > 0) soft.ref[0] = std::max(soft.ref[0], 2 * model.opt.timestep);
  const auto within = [](double x) { return std::min(mjMAXIMP, std::max(mjMINIMP, x)); };
  soft.imp = {within(imp[0]), within(imp[1]), std::max(0.0, imp[2]), within(imp[3]), std::max(1.0, imp[4])};
  return soft;
}

// What a product lacks, by Dekker's halves of numbers.
double rest_of_product(double a, double b, double product) {
  const auto upper = [](double x) {
    const double split = 134217729 * x;
    return split - (split - x);
  };
  const double a_high = upper(a), a_low = a - a_high, b_high = upper(b), b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

struct Impedance {
  double value, slope;
};

// At this depth beyond the margin. False where only MuJoCo knows what its pow gives.
bool find_impedance(const std::array<double, mjNIMP>& imp, double depth, Impedance& found) {
  const auto [low, high, width, middle, power] = imp;
  if (low == high || width <= mjMINVAL) {
    found = {0.5 * (low + high), 0};
    return true;
  }
  const double signed_share = depth / width, share = std::abs(signed_share);
  if (share >= 1 || share <= 0) {
    found = {share >= 1 ? high : low, 0};
    return true;
  }
  double y = share, slope = 1;
  if (power != 1) {
    const bool lower = share <= middle;
    const double base = lower ? share : 1 - share;
    double whole = 0, part = 0, less = 0;
    if (!find_power(lower ? middle : 1 - middle, power - 1, whole) || !find_power(base, power, part) ||
        !find_power(base, power - 1, less)) {
      return false;
    }
    const double scale = 1 / whole;
    y = lower ? scale * part : 1 - scale * part;
    slope = power * scale * less;
  }
  found = {low + y * (high - low), slope * (signed_share < 0 ? -1 : 1) * (high - low) / width};
  return true;
}

// Of `rows` that begin with this one; `push` and `turn` are the weights of bodies or joints.
bool write_softness(mjData& data, int row, int rows, const Softness& soft, double push, double turn) {
  Impedance impedance{};
  if (!find_impedance(soft.imp, data.efc_pos[row] - data.efc_margin[row], impedance)) return false;
  const auto& ref = soft.ref;
  const double value = impedance.value, high = soft.imp[1];
  const double stiffness = ref[0] > 0 ? 1 / std::max(mjMINVAL, high * high * ref[0] * ref[0] * ref[1] * ref[1])
                                      : -ref[0] / std::max(mjMINVAL, high * high);
  const double damping = ref[1] > 0 ? 2 / std::max(mjMINVAL, high * ref[0]) : -ref[1] / std::max(mjMINVAL, high);
  const bool rubs = data.efc_type[row] == mjCNSTR_FRICTION_DOF;
  for (int i = 0; i < rows; ++i) {
    data.efc_R[row + i] = std::max(mjMINVAL, (1 - value) * (i < 3 ? push : turn) / value);
    double* numbers = data.efc_KBIP + 4 * (row + i);
    numbers[0] = rubs || i > 0 ? 0 : stiffness;
    numbers[1] = damping;
    numbers[2] = value;
    numbers[3] = impedance.slope;
  }
  return true;
}

bool soften_contact(const mjModel& model, mjData& data, int row) {
  mjContact& contact = data.contact[data.efc_id[row]];
  const double* first = model.body_invweight0 + 2 * model.geom_bodyid[contact.geom1];
  const double* second = model.body_invweight0 + 2 * model.geom_bodyid[contact.geom2];
  const Softness soft = softness_of(model, contact.solref, contact.solimp);
  if (!write_softness(data, row, contact.dim, soft, first[0] + second[0], first[1] + second[1])) return false;
  if (contact.dim == 1) return true;
  double* resistance = data.efc_R + row;
  const double* friction = contact.friction;
  resistance[1] = resistance[0] / std::max(mjMINVAL, model.opt.impratio);
  contact.mu = friction[0] * std::sqrt(resistance[1] / resistance[0]);
  for (int i = 1; i < contact.dim - 1; ++i) {
    resistance[i + 1] = resistance[1] * friction[0] * friction[0] / (friction[i] * friction[i]);
  }
  return true;
}

bool soften_single(const mjModel& model, mjData& data, int row) {
  const int id = data.efc_id[row];
  const auto write = [&](const double* ref, const double* imp, double weight) {
    return write_softness(data, row, 1, softness_of(model, ref + mjNREF * id, imp + mjNIMP * id), weight, weight);
  };
  switch (data.efc_type[row]) {
    case mjCNSTR_FRICTION_DOF: return write(model.dof_solref, model.dof_solimp, model.dof_invweight0[id]);
    case mjCNSTR_LIMIT_JOINT:
      return write(model.jnt_solref, model.jnt_solimp, model.dof_invweight0[model.jnt_dofadr[id]]);
    default: return write(model.tendon_solref_lim, model.tendon_solimp_lim, model.tendon_invweight0[id]);
  }
}

bool soften(const mjModel& model, mjData& data) {
  for (int row = 0; row < data.nefc;) {
    const bool single = data.efc_type[row] <= mjCNSTR_LIMIT_TENDON;
    if (!(single ? soften_single(model, data, row) : soften_contact(model, data, row))) return false;
    row += single ? 1 : data.contact[data.efc_id[row]].dim;
  }
  for (int i = 0; i < data.nefc; ++i) {
    const double value = data.efc_KBIP[4 * i + 2];
    data.efc_D[i] = 1 / data.efc_R[i];
    data.efc_diagApprox[i] = data.efc_R[i] * value / (1 - value);
  }
  return true;
}

}  // namespace

// A library's pow errs by a little more than half of a last digit (glibc's by .512), so it rounds as the exact power
// does, except where that is about half way between two numbers.
bool find_power(double x, double power, double& found) {
  found = x;
  if (power == 1) return true;
  double rest = 0;
  if (power == 2) {
    found = x * x;
    rest = rest_of_product(x, x, found);
  } else if (power == 0.5 || power == 1.5) {
    const double root = std::sqrt(x), square = root * root;
    found = root;
    rest = ((x - square) - rest_of_product(root, root, square)) / (2 * root);
    if (power == 1.5) {
      const double product = x * root;
      rest = rest_of_product(x, root, product) + x * rest;
      found = product + rest;
      rest += product - found;
    }
  } else {
    return false;
  }
  return x > 1e-6 && found + 1.03 * rest == found;
}

MIMO_ALSO_FOR_AVX2
void make_constraints(const mjModel& model, mjData& data) {
  data.ne = data.nf = data.nefc = 0;
  if (!is_on(model, mjDSBL_CONSTRAINT) || model.njmax == 0) return;
  const bool ours = is_usual(model) && add_frictions(model, data) && add_limits(model, data) &&
                    add_contacts(model, data) && soften(model, data);
  if (!ours) return mj_makeConstraint(&model, &data);
  data.maxuse_con = std::max(data.maxuse_con, data.ncon);
  data.maxuse_efc = std::max(data.maxuse_efc, data.nefc);
}

}  // namespace mimo::solver

#endif
