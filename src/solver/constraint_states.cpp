#include "solver/constraint_states.h"

#include <algorithm>
#include <cmath>

namespace mimo::solver {
namespace {

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

double cost_of(const mjData& data, const Blocks& blocks, const double* violation) {
  return visit(data, blocks, violation, [](int, mjtConstraintState, double) {});
}

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
