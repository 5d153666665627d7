#include "solver/line_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/stack.h"

namespace mimo::solver {
namespace {

constexpr int kMostEvaluations = 50;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Slope {
  double first, second;  // derivatives of the cost
};

// Rows that stand for themselves. All are springs within their bounds: friction of joints yields at both, limits and
// contacts without friction only push, equalities have none. As many as fill whole lanes; the last ones weigh nothing.
constexpr int kLanes = 4;
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
  double first[kLanes] = {}, second[kLanes] = {};
  for (int i = 0; i < springs.count; i += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const int k = i + lane;
      const double value = springs.start[k] + at * springs.change[k];
      const double bent = std::min(std::max(value, springs.low[k]), springs.high[k]);
      first[lane] += springs.weight[k] * bent;
      second[lane] += bent == value ? springs.weight[k] * springs.change[k] : 0;
    }
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

void add_spring(const mjData& data, const Line& line, int row, Springs& springs) {
  const int at = springs.count++;
  springs.start[at] = line.start[row];
  springs.change[at] = line.direction[row];
  springs.weight[at] = data.efc_D[row] * line.direction[row];
  springs.low[at] = -kInfinity;
  springs.high[at] = kInfinity;
  if (row >= data.ne + data.nf) {
    springs.high[at] = 0;
  } else if (row >= data.ne) {
    springs.high[at] = data.efc_R[row] * data.efc_frictionloss[row];
    springs.low[at] = -springs.high[at];
  }
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
  for (int row = 0; row < data.nefc; ++row) {
    if (data.efc_type[row] != mjCNSTR_CONTACT_ELLIPTIC) {
      add_spring(data, line, row, springs);
      continue;
    }
    cones[count++] = cone_of(data, line, row);
    row += data.contact[data.efc_id[row]].dim - 1;
  }
  for (; springs.count % kLanes != 0; ++springs.count) {
    for (double* numbers : {springs.start, springs.change, springs.low, springs.high, springs.weight}) {
      numbers[springs.count] = 0;
    }
  }
  return {springs, count, cones};
}

}  // namespace

// The slope grows along the line, so a place where it is negative and one where it is positive hold the least between
// them. Newton's steps lead there. Halves are taken where such a step leads out, and where steps do not get shorter
// quickly: the slope of a cone is shaped like an S, and they can bounce from one end of it to the other for ever.
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

}  // namespace mimo::solver
