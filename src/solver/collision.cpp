#include "solver/collision.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "compat/mujoco.h"
#include "solver/shape_pair.h"
#include "solver/stack.h"

namespace mimo::solver {

#if MIMO_MUJOCO_4

void collide(const mjModel& model, mjData& data) { mj_collision(&model, &data); }

#else

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
