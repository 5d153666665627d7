#include "engine/line_search.h"

#include <cmath>
#include <limits>

#include "engine/solver_stack.h"

namespace mimo::engine {
namespace {

constexpr int kMostEvaluations = 50;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Slope {
  double first, second;  // derivatives of the cost
};

// A contact with friction, in units in which its cone is round.
struct Cone {
  int rows;
  double friction;
  double normal, normal_change;
  double tangent, tangent_mixed, tangent_change;  // square of the tangential part: t + 2 a m + a^2 c
  double stiffness;
  double slope, curvature;  // while the contact sticks
};

Cone cone_of(const mjData& data, const Line& line, int row) {
  const mjContact& contact = data.contact[data.efc_id[row]];
  const double mu = contact.mu;
  Cone cone{};
  cone.rows = contact.dim;
  cone.friction = mu;
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
  const double square = cone.tangent + at * (2 * cone.tangent_mixed + at * cone.tangent_change);
  const double tangent = square > 0 ? std::sqrt(square) : 0;
  if (normal >= mu * tangent) return;  // apart
  if (mu * normal + tangent <= 0) {    // sticks
    sum.first += cone.slope + at * cone.curvature;
    sum.second += cone.curvature;
    return;
  }
  const double first = (cone.tangent_mixed + at * cone.tangent_change) / tangent;
  const double second = cone.tangent_change / tangent - first * first / tangent;
  const double depth = normal - mu * tangent, change = cone.normal_change - mu * first;
  sum.first += cone.stiffness * depth * change;
  sum.second += cone.stiffness * (change * change - depth * mu * second);
}

// Friction in a joint: of second order near zero, a constant force beyond.
void add_friction(const mjData& data, const Line& line, int row, double at, Slope& sum) {
  const double value = line.start[row] + at * line.direction[row];
  const double bound = data.efc_R[row] * data.efc_frictionloss[row];
  if (-bound < value && value < bound) {
    sum.first += data.efc_D[row] * value * line.direction[row];
    sum.second += data.efc_D[row] * line.direction[row] * line.direction[row];
  } else {
    sum.first += (value < 0 ? -1 : 1) * data.efc_frictionloss[row] * line.direction[row];
  }
}

Slope slope_at(const mjData& data, const Line& line, const Cone* cones, double at) {
  Slope sum{line.slope + at * line.curvature, line.curvature};
  const int friction = data.ne, one_sided = data.ne + data.nf;
  for (int row = 0; row < data.nefc; ++row) {
    if (row >= friction && row < one_sided) {
      add_friction(data, line, row, at, sum);
    } else if (data.efc_type[row] == mjCNSTR_CONTACT_ELLIPTIC) {
      const Cone& cone = cones[data.efc_id[row]];
      add_cone(cone, at, sum);
      row += cone.rows - 1;
    } else {
      const double value = line.start[row] + at * line.direction[row];
      if (row >= one_sided && value >= 0) continue;
      sum.first += data.efc_D[row] * value * line.direction[row];
      sum.second += data.efc_D[row] * line.direction[row] * line.direction[row];
    }
  }
  return sum;
}

Cone* prepare_cones(mjData& data, const Line& line) {
  Cone* cones = take<Cone>(data, data.ncon);
  for (int row = data.ne + data.nf; row < data.nefc; ++row) {
    if (data.efc_type[row] != mjCNSTR_CONTACT_ELLIPTIC) continue;
    Cone& cone = cones[data.efc_id[row]];
    cone = cone_of(data, line, row);
    row += cone.rows - 1;
  }
  return cones;
}

}  // namespace

// The slope grows along the line, so a place where it is negative and one where it is positive hold the least between
// them. Newton's steps lead there. Halves are taken where such a step leads out, and where steps do not get shorter
// quickly: the slope of a cone is shaped like an S, and they can bounce from one end of it to the other for ever.
double find_least(mjData& data, const Line& line, double tolerance) {
  const compat::StackMark stack = compat::mark_stack(data);
  const Cone* cones = prepare_cones(data, line);
  double low = 0, high = kInfinity, at = 0, moved = kInfinity;
  double best = 0, flattest = kInfinity;  // rounding may end the search where the slope is not within the tolerance
  Slope slope = slope_at(data, line, cones, at);
  for (int i = 1; i < kMostEvaluations && slope.first != 0; ++i) {
    double next = at - slope.first / slope.second;
    const bool slow = high < kInfinity && std::abs(next - at) > 0.5 * moved;
    if (slow || next <= low || next >= high) next = 0.5 * (low + high);
    if (next == low || next == high) break;  // there is no number between
    moved = std::abs(next - at);
    at = next;
    slope = slope_at(data, line, cones, at);
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

}  // namespace mimo::engine
