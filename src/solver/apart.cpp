#include "solver/apart.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mimo::solver {
namespace {

using Vector = std::array<double, 3>;

// MuJoCo's general function for convex shapes is exact to its tolerance only.
constexpr double kLeastGap = 1e-5;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Shape {
  int type;
  const double* size;
  const double* center;
  std::array<Vector, 3> axes;
};

Shape shape_of(const mjModel& model, const mjData& data, int geom) {
  const double* m = data.geom_xmat + 9 * geom;
  return {model.geom_type[geom],
          model.geom_size + 3 * geom,
          data.geom_xpos + 3 * geom,
          {Vector{m[0], m[3], m[6]}, Vector{m[1], m[4], m[7]}, Vector{m[2], m[5], m[8]}}};
}

bool is_round(int type) { return type == mjGEOM_CAPSULE || type == mjGEOM_CYLINDER; }

// How far a shape reaches from its centre in a direction of length 1.
double reach(const Shape& shape, const Vector& direction) {
  const double* size = shape.size;
  if (shape.type == mjGEOM_SPHERE) return size[0];
  const double along = std::abs(dot(direction, shape.axes[2]));
  if (shape.type == mjGEOM_CAPSULE) return size[0] + size[1] * along;
  if (shape.type == mjGEOM_CYLINDER) {
    return size[0] * std::sqrt(std::max(0.0, 1 - along * along)) + size[1] * along;
  }
  return size[0] * std::abs(dot(direction, shape.axes[0])) + size[1] * std::abs(dot(direction, shape.axes[1])) +
         size[2] * along;
}

class Pair {
 public:
  Pair(const Shape& first, const Shape& second, double margin) : first_(first), second_(second), margin_(margin) {
    for (std::size_t i = 0; i < 3; ++i) between_[i] = second.center[i] - first.center[i];
  }

  bool parted_by_faces(const Shape& shape) const {
    if (shape.type == mjGEOM_BOX) return parted(shape.axes[0]) || parted(shape.axes[1]) || parted(shape.axes[2]);
    return shape.type == mjGEOM_CYLINDER && parted(shape.axes[2]);
  }

  // By a plane along the axis of one of them.
  bool parted_by_side(const Shape& shape) const {
    if (!is_round(shape.type)) return false;
    const double along = dot(between_, shape.axes[2]);
    Vector side;
    for (std::size_t i = 0; i < 3; ++i) side[i] = between_[i] - along * shape.axes[2][i];
    return parted_along(side);
  }

  bool parted_between() const { return parted_along(between_); }

 private:
  bool parted_along(Vector direction) const {
    const double length = std::sqrt(dot(direction, direction));
    if (!(length > mjMINVAL)) return false;
    for (double& x : direction) x /= length;
    return parted(direction);
  }

  bool parted(const Vector& direction) const {
    return std::abs(dot(between_, direction)) > reach(first_, direction) + reach(second_, direction) + margin_;
  }

  const Shape &first_, &second_;
  double margin_;
  Vector between_;
};

bool is_simple(int type) { return type == mjGEOM_SPHERE || is_round(type) || type == mjGEOM_BOX; }
bool is_costly(int type) { return type == mjGEOM_CYLINDER || type == mjGEOM_BOX; }

}  // namespace

bool are_apart(const mjModel& model, const mjData& data, int geom, int other, double margin) {
  const int type = model.geom_type[geom], other_type = model.geom_type[other];
  if (!is_simple(type) || !is_simple(other_type) || !(is_costly(type) || is_costly(other_type))) return false;
  const Shape first = shape_of(model, data, geom), second = shape_of(model, data, other);
  const Pair pair(first, second, margin + kLeastGap);
  return pair.parted_by_faces(first) || pair.parted_by_faces(second) || pair.parted_by_side(first) ||
         pair.parted_by_side(second) || pair.parted_between();
}

}  // namespace mimo::solver
