#include "solver/collision.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "compat/mujoco.h"
#include "solver/constraints.h"

namespace mimo::solver {
namespace {

using Vector = std::array<double, 3>;

// MuJoCo's general function for convex shapes is exact to its tolerance only.
constexpr double kLeastGap = 1e-5;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct PlacedGeom {
  int type;
  const double* size;
  const double* center;
  std::array<Vector, 3> axes;
};

PlacedGeom shape_of(const mjModel& model, const mjData& data, int geom) {
  const double* m = data.geom_xmat + 9 * geom;
  return {model.geom_type[geom],
          model.geom_size + 3 * geom,
          data.geom_xpos + 3 * geom,
          {Vector{m[0], m[3], m[6]}, Vector{m[1], m[4], m[7]}, Vector{m[2], m[5], m[8]}}};
}

bool is_round(int type) { return type == mjGEOM_CAPSULE || type == mjGEOM_CYLINDER; }

// How far a shape reaches from its centre in a direction of length 1.
double reach(const PlacedGeom& shape, const Vector& direction) {
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
  Pair(const PlacedGeom& first, const PlacedGeom& second, double margin)
      : first_(first), second_(second), margin_(margin) {
    for (std::size_t i = 0; i < 3; ++i) between_[i] = second.center[i] - first.center[i];
  }

  bool parted_by_faces(const PlacedGeom& shape) const {
    if (shape.type == mjGEOM_BOX) return parted(shape.axes[0]) || parted(shape.axes[1]) || parted(shape.axes[2]);
    return shape.type == mjGEOM_CYLINDER && parted(shape.axes[2]);
  }

  // By a plane along the axis of one of them.
  bool parted_by_side(const PlacedGeom& shape) const {
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

  const PlacedGeom &first_, &second_;
  double margin_;
  Vector between_;
};

bool is_simple(int type) { return type == mjGEOM_SPHERE || is_round(type) || type == mjGEOM_BOX; }
bool is_costly(int type) { return type == mjGEOM_CYLINDER || type == mjGEOM_BOX; }

}  // namespace

bool are_apart(const mjModel& model, const mjData& data, int geom, int other, double margin) {
  const int type = model.geom_type[geom], other_type = model.geom_type[other];
  if (!is_simple(type) || !is_simple(other_type) || !(is_costly(type) || is_costly(other_type))) return false;
  const PlacedGeom first = shape_of(model, data, geom), second = shape_of(model, data, other);
  const Pair pair(first, second, margin + kLeastGap);
  return pair.parted_by_faces(first) || pair.parted_by_faces(second) || pair.parted_by_side(first) ||
         pair.parted_by_side(second) || pair.parted_between();
}

#if MIMO_MUJOCO_4

void collide(const mjModel& model, mjData& data) { mj_collision(&model, &data); }

#else
namespace {

// How two shapes touch, where they do.
struct Rules {
  double margin, gap;
  int dimensions;
  std::array<double, 5> friction;
  std::array<double, mjNREF> solref;
  std::array<double, mjNIMP> solimp;
};

double plane_distance(const mjData& data, int plane, int geom) {
  const double* normal = data.geom_xmat + 9 * plane + 2;
  const double *from = data.geom_xpos + 3 * plane, *to = data.geom_xpos + 3 * geom;
  return (to[0] - from[0]) * normal[0] + (to[1] - from[1]) * normal[3] + (to[2] - from[2]) * normal[6];
}

// By the spheres around them; `first` is the plane if there is one.
bool are_far(const mjModel& model, const mjData& data, int first, int second, double margin) {
  const double radius = model.geom_rbound[first], other = model.geom_rbound[second];
  if (radius > 0 && other > 0) {
    return mju_dist3(data.geom_xpos + 3 * first, data.geom_xpos + 3 * second) > radius + other + margin;
  }
  return model.geom_type[first] == mjGEOM_PLANE && other > 0 && plane_distance(data, first, second) > margin + other;
}

void order_by_type(const mjModel& model, int& first, int& second) {
  if (model.geom_type[first] > model.geom_type[second]) std::swap(first, second);
}

// Two boxes may report a point twice.
int drop_repeated(mjContact* contacts, int count) {
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    const double* point = contacts[i].pos;
    const bool again = std::any_of(contacts + i + 1, contacts + count, [&](const mjContact& later) {
      return point[0] == later.pos[0] && point[1] == later.pos[1] && point[2] == later.pos[2];
    });
    if (again) continue;
    if (kept < i) contacts[kept] = contacts[i];
    ++kept;
  }
  return kept;
}

// Completes the axes of a contact: the first is the normal, the second may be a wish.
void complete_frame(double* frame) {
  if (mju_normalize3(frame) < 0.5) mju_error("the normal of a contact is undefined");
  if (mju_norm3(frame + 3) < 0.5) {
    mju_zero3(frame + 3);
    frame[frame[1] < 0.5 && frame[1] > -0.5 ? 4 : 5] = 1;
  }
  double along[3];
  mju_scl3(along, frame, mju_dot3(frame, frame + 3));
  mju_subFrom3(frame + 3, along);
  mju_normalize3(frame + 3);
  mju_cross(frame + 6, frame, frame + 3);
}

// Calls `complete` for the rules of friction and softness only where there are contacts.
template <typename Complete>
void collide_ordered(const mjModel& model, mjData& data, int first, int second, Rules& rules, Complete&& complete) {
  const int type = model.geom_type[first], other_type = model.geom_type[second];
  const mjfCollision find = mjCOLLISIONFUNC[type][other_type];
  if (find == nullptr || are_far(model, data, first, second, rules.margin)) return;
  if (are_apart(model, data, first, second, rules.margin)) return;
  std::array<mjContact, mjMAXCONPAIR> contacts;
  int count = find(&model, &data, contacts.data(), first, second, rules.margin);
  if (count == 0) return;
  if (type == mjGEOM_BOX && other_type == mjGEOM_BOX) count = drop_repeated(contacts.data(), count);
  complete();
  for (double& friction : rules.friction) friction = std::max(mjMINMU, friction);
  for (int i = 0; i < count; ++i) {
    mjContact& contact = contacts[static_cast<std::size_t>(i)];
    contact.dim = rules.dimensions;
    contact.geom1 = first;
    contact.geom2 = second;
    contact.includemargin = rules.margin - rules.gap;
    contact.exclude = contact.dist < contact.includemargin ? 0 : 1;
    std::copy_n(rules.friction.data(), 5, contact.friction);
    std::copy_n(rules.solref.data(), mjNREF, contact.solref);
    std::copy_n(rules.solimp.data(), mjNIMP, contact.solimp);
    complete_frame(contact.frame);
    contact.efc_address = -1;
    contact.mu = 0;
    std::fill(std::begin(contact.H), std::end(contact.H), 0.0);
    if (mj_addContact(&model, &data, &contact) != 0) return;
  }
}

void take_rules_of(const mjModel& model, int geom, Rules& rules) {
  const double* friction = model.geom_friction + 3 * geom;
  rules.friction = {friction[0], friction[0], friction[1], friction[2], friction[2]};
  std::copy_n(model.geom_solref + mjNREF * geom, mjNREF, rules.solref.data());
  std::copy_n(model.geom_solimp + mjNIMP * geom, mjNIMP, rules.solimp.data());
}

double share_of_first(double first, double second) {
  if (first >= mjMINVAL && second >= mjMINVAL) return first / (first + second);
  if (first < mjMINVAL && second < mjMINVAL) return 0.5;
  return first < mjMINVAL ? 0 : 1;
}

void mix_rules(const mjModel& model, int first, int second, Rules& rules) {
  const double *one = model.geom_friction + 3 * first, *other = model.geom_friction + 3 * second;
  const double slide = std::max(one[0], other[0]), roll = std::max(one[2], other[2]);
  rules.friction = {slide, slide, std::max(one[1], other[1]), roll, roll};
  const double share = share_of_first(model.geom_solmix[first], model.geom_solmix[second]);
  const double *ref = model.geom_solref + mjNREF * first, *other_ref = model.geom_solref + mjNREF * second;
  const bool standard = ref[0] > 0 && other_ref[0] > 0;
  for (std::size_t i = 0; i < mjNREF; ++i) {
    rules.solref[i] = standard ? share * ref[i] + (1 - share) * other_ref[i] : std::min(ref[i], other_ref[i]);
  }
  const double *imp = model.geom_solimp + mjNIMP * first, *other_imp = model.geom_solimp + mjNIMP * second;
  for (std::size_t i = 0; i < mjNIMP; ++i) rules.solimp[i] = imp[i] * share + other_imp[i] * (1 - share);
}

}  // namespace

void collide_shapes(const mjModel& model, mjData& data, int geom, int other) {
  const bool match = (model.geom_contype[geom] & model.geom_conaffinity[other]) != 0 ||
                     (model.geom_contype[other] & model.geom_conaffinity[geom]) != 0;
  if (!match) return;
  int first = geom, second = other;
  order_by_type(model, first, second);
  const int priority = model.geom_priority[first], other_priority = model.geom_priority[second];
  const int chief = priority > other_priority ? first : second;
  Rules rules;
  rules.margin = std::max(model.geom_margin[first], model.geom_margin[second]);
  rules.gap = std::max(model.geom_gap[first], model.geom_gap[second]);
  rules.dimensions = priority == other_priority ? std::max(model.geom_condim[first], model.geom_condim[second])
                                                : model.geom_condim[chief];
  collide_ordered(model, data, first, second, rules, [&] {
    if (priority == other_priority) {
      mix_rules(model, first, second, rules);
    } else {
      take_rules_of(model, chief, rules);
    }
  });
}

void collide_pair(const mjModel& model, mjData& data, int pair) {
  int first = model.pair_geom1[pair], second = model.pair_geom2[pair];
  order_by_type(model, first, second);
  Rules rules;
  rules.margin = model.pair_margin[pair];
  rules.gap = model.pair_gap[pair];
  rules.dimensions = model.pair_dim[pair];
  collide_ordered(model, data, first, second, rules, [&] {
    std::copy_n(model.pair_friction + 5 * pair, 5, rules.friction.data());
    std::copy_n(model.pair_solref + mjNREF * pair, mjNREF, rules.solref.data());
    std::copy_n(model.pair_solimp + mjNIMP * pair, mjNIMP, rules.solimp.data());
  });
}

namespace {

using Mark = unsigned char;

// Comparing every shape with every other grows with the square; beyond, MuJoCo sorts.
constexpr int kMostShapes = 512;

// Spheres around all shapes that can touch something, in single precision and larger by more than its rounding.
struct Spheres {
  int count;
  int* geoms;  // ascending, so those of a body follow each other
  float *x, *y, *z, *radius;
};

bool can_touch(const mjModel& model, int geom) {
  return model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
}

bool is_endless(const mjModel& model, int geom) {
  return model.geom_type[geom] == mjGEOM_PLANE || model.geom_type[geom] == mjGEOM_HFIELD;
}

void add_sphere(const mjModel& model, const mjData& data, int geom, Spheres& spheres) {
  constexpr double kRounding = 1e-6;
  const double* center = data.geom_xpos + 3 * geom;
  const double reach = model.geom_rbound[geom] + model.geom_margin[geom];
  const double spread = reach + std::abs(center[0]) + std::abs(center[1]) + std::abs(center[2]);
  const int at = spheres.count++;
  spheres.geoms[at] = geom;
  spheres.x[at] = static_cast<float>(center[0]);
  spheres.y[at] = static_cast<float>(center[1]);
  spheres.z[at] = static_cast<float>(center[2]);
  spheres.radius[at] = model.geom_rbound[geom] > 0 ? static_cast<float>(reach + kRounding * spread)
                                                   : std::numeric_limits<float>::infinity();
}

// False for what only MuJoCo's own search treats as it does: a plane of a body that stands on the world is compared
// with some shapes twice, and a negative margin shrinks the box around a body but not what its shapes touch.
bool gather(const mjModel& model, mjData& data, Spheres& spheres) {
  const int most = std::min(model.ngeom, kMostShapes);
  spheres = {0,
             take<int>(data, most),
             take<float>(data, most),
             take<float>(data, most),
             take<float>(data, most),
             take<float>(data, most)};
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (!can_touch(model, geom)) continue;
    if (is_endless(model, geom) && model.geom_bodyid[geom] != 0) return false;
    if (model.geom_margin[geom] < 0 || spheres.count == kMostShapes) return false;
    add_sphere(model, data, geom, spheres);
  }
  return true;
}

// Marks what is near one of them, from `first` on.
void mark_near(const Spheres& spheres, int of, int first, Mark* __restrict near) {
  const float x = spheres.x[of], y = spheres.y[of], z = spheres.z[of], radius = spheres.radius[of];
  for (int i = first; i < spheres.count; ++i) {
    const float dx = spheres.x[i] - x, dy = spheres.y[i] - y, dz = spheres.z[i] - z;
    const float reach = spheres.radius[i] + radius;
    near[i] = static_cast<Mark>(near[i] | static_cast<Mark>(dx * dx + dy * dy + dz * dz <= reach * reach));
  }
}

int next_mark(const Mark* marks, int at, int end) {
  for (; at + 8 <= end; at += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, marks + at, 8);
    if (eight != 0) break;
  }
  while (at < end && marks[at] == 0) ++at;
  return at;
}

// Bodies that move as one do not touch, and neither do parent and child unless the model says so.
bool may_touch(const mjModel& model, int first, int second) {
  const int one = model.body_weldid[first], other = model.body_weldid[second];
  if (one == other) return false;
  if (one == 0 || other == 0 || (model.opt.disableflags & mjDSBL_FILTERPARENT) != 0) return true;
  return one != model.body_weldid[model.body_parentid[other]] && other != model.body_weldid[model.body_parentid[one]];
}

// Goes through pairs of bodies in ascending order, and at the same pace through the model's lists of pairs of shapes
// that touch by rules of their own, and of bodies that never do.
class Walk {
 public:
  Walk(const mjModel& model, mjData& data)
      : model_(model), data_(data), pairs_(model.opt.collision == mjCOL_ALL ? model.npair : 0) {}

  void visit(int first, int second) {
    const int signature = ((first + 1) << 16) + second + 1;
    const int start = pair_;
    while (pair_ < pairs_ && model_.pair_signature[pair_] <= signature) collide_pair(model_, data_, pair_++);
    while (exclude_ < model_.nexclude && model_.exclude_signature[exclude_] < signature) ++exclude_;
    if (exclude_ < model_.nexclude && model_.exclude_signature[exclude_] == signature) return;
    if (may_touch(model_, first, second)) collide_bodies(first, second, start);
  }

  void finish() {
    while (pair_ < pairs_) collide_pair(model_, data_, pair_++);
  }

 private:
  void collide_bodies(int first, int second, int start) const {
    const int end = model_.body_geomadr[first] + model_.body_geomnum[first];
    const int others_end = model_.body_geomadr[second] + model_.body_geomnum[second];
    for (int geom = model_.body_geomadr[first]; geom < end; ++geom) {
      for (int other = model_.body_geomadr[second]; other < others_end; ++other) {
        if (!has_own_rules(geom, other, start)) collide_shapes(model_, data_, geom, other);
      }
    }
  }

  bool has_own_rules(int geom, int other, int start) const {
    for (int i = start; i < pair_; ++i) {
      const int one = model_.pair_geom1[i], two = model_.pair_geom2[i];
      if ((one == geom && two == other) || (one == other && two == geom)) return true;
    }
    return false;
  }

  const mjModel& model_;
  mjData& data_;
  int pairs_, pair_ = 0, exclude_ = 0;
};

void walk(const mjModel& model, mjData& data, const Spheres& spheres) {
  Walk pairs(model, data);
  Mark* near = take<Mark>(data, spheres.count);
  const auto body_of = [&](int at) { return model.geom_bodyid[spheres.geoms[at]]; };
  const auto end_of_body = [&](int at) {
    const int body = body_of(at);
    while (at < spheres.count && body_of(at) == body) ++at;
    return at;
  };
  for (int start = 0; start < spheres.count;) {
    const int end = end_of_body(start);
    std::fill(near + end, near + spheres.count, Mark{0});
    for (int i = start; i < end; ++i) mark_near(spheres, i, end, near);
    for (int at = next_mark(near, end, spheres.count); at < spheres.count;) {
      pairs.visit(body_of(start), body_of(at));
      at = next_mark(near, end_of_body(at), spheres.count);
    }
    start = end;
  }
  pairs.finish();
}

bool is_off(const mjModel& model) {
  return (model.opt.disableflags & (mjDSBL_CONSTRAINT | mjDSBL_CONTACT)) != 0 || model.nconmax == 0 || model.nbody < 2;
}

bool has_usual_rules(const mjModel& model) {
  return model.opt.collision != mjCOL_PAIR && (model.opt.enableflags & mjENBL_OVERRIDE) == 0;
}

}  // namespace

void collide(const mjModel& model, mjData& data) {
  data.ncon = 0;
  if (is_off(model)) return;
  const compat::StackMark stack = compat::mark_stack(data);
  Spheres spheres{};
  const bool ours = has_usual_rules(model) && gather(model, data, spheres);
  if (ours) walk(model, data, spheres);
  compat::release_stack(data, stack);
  if (!ours) mj_collision(&model, &data);
}

#endif

}  // namespace mimo::solver
