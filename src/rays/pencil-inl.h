// The triangles of a mesh that many rays from one point may meet: boxes are looked at once for all of these rays, and
// of many triangles at a time those are left out that none can meet.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_PENCIL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_PENCIL_INL_H
#undef MIMO_RAYS_PENCIL_INL_H
#else
#define MIMO_RAYS_PENCIL_INL_H
#endif

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rays/camera.h"
#include "rays/lanes-inl.h"
#include "rays/mesh-inl.h"
#include "rays/meshes.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// Where rays come from, and three axes: slopes are right and up over ahead. Or all go ahead in parallel: then these are
// places instead.
struct Sight {
  std::array<float, 3> o, right, up, ahead;
  bool parallel;
};

inline Sight SightOf(const Aspect& aspect, bool parallel) {
  if (parallel) return {aspect.a, aspect.bx, aspect.by, aspect.o, true};
  return {aspect.o, aspect.bx, aspect.by, aspect.a, false};
}

// Rays whose slopes lie within these bounds, as far as something may be met.
struct Pencil {
  float low[2], high[2];
  float farthest;
};

// The sides of a pencil, in the frame of a mesh: planes that have it before them.
class Sides {
 public:
  Sides(const Mesh& mesh, const Sight& sight, const Pencil& pencil) {
    const auto put = [&](int i, float along_x, float along_y, float along_z, float from) {
      float size = std::abs(from);
      distance_[i] = from;
      for (int k = 0; k < 3; ++k) {
        const float n = along_x * sight.right[k] + along_y * sight.up[k] + along_z * sight.ahead[k];
        normal_[i][k] = n;
        distance_[i] -= n * sight.o[k];
        size += std::abs(n) * (std::abs(sight.o[k]) + mesh.half[k]);
      }
      distance_[i] += 1e-5F * size;  // for what is rounded
    };
    const auto bound = [&](int i, float along_x, float along_y, float at) {
      put(i, along_x, along_y, sight.parallel ? 0 : at, sight.parallel ? at : 0);
    };
    bound(0, 1, 0, -pencil.low[0]);
    bound(1, -1, 0, pencil.high[0]);
    bound(2, 0, 1, -pencil.low[1]);
    bound(3, 0, -1, pencil.high[1]);
    put(4, 0, 0, 1, sight.parallel ? kMiss : 0);
    put(5, 0, 0, -1, pencil.farthest);
    slack_ = 0;
    for (int k = 0; k < 3; ++k) {
      eye_[k] = sight.o[k];
      slack_ += 0.01F * (std::abs(sight.o[k]) + mesh.half[k]);
    }
  }

  // The boxes `first` and following that rays of the pencil may meet; unless backs count too, those in which triangles
  // may turn to the eye.
  template <bool kBackToo>
  HWY_INLINE M may_meet(const Branch& branch, int first) const {
    M may = hn::FirstN(D(), static_cast<std::size_t>(branch.count - first));
    for (int i = 0; i < kSides; ++i) {
      V most = Set(distance_[i]);
      for (int k = 0; k < 3; ++k) {
        const float n = normal_[i][k];
        most = most + Set(n) * Load((n > 0 ? branch.high : branch.low)[k] + first);
      }
      may = hn::And(may, hn::Ge(most, Zero()));
    }
    return kBackToo || None(may) ? may : hn::AndNot(turn_away(branch, first), may);
  }

 private:
  static constexpr int kSides = 6;

  // Boxes whose triangles all turn their backs to the eye, wherever in the box they are: from the least of the product
  // of a normal and the way to a corner. (A ten-thousandth of the way: nothing is seen edgeways.)
  HWY_INLINE M turn_away(const Branch& branch, int first) const {
    V along = Zero();
    V way = Set(slack_);
    for (int k = 0; k < 3; ++k) {
      const V low = Load(branch.low[k] + first) - Set(eye_[k]);
      const V high = Load(branch.high[k] + first) - Set(eye_[k]);
      const V least = Load(branch.least[k] + first);
      const V most = Load(branch.most[k] + first);
      along = along + hn::Min(hn::Min(low * least, low * most), hn::Min(high * least, high * most));
      way = way + hn::Max(hn::Abs(low), hn::Abs(high));
    }
    return hn::Gt(along, way * Set(1e-4F));
  }

  float eye_[3];
  float slack_;  // for what is rounded of the way
  float normal_[kSides][3];
  float distance_[kSides];
};

// For what is rounded in slopes of a triangle's corners, relative to one and more.
constexpr float kHairOfOutline = 1e-5F;

// Triangles that rays of a pencil may meet, one a lane.
struct Candidates {
  V number[9];        // corner, edge1, edge2
  V at[3][2];         // slopes of the corners, nothing of use where they are bound by kMiss
  V low[2], high[2];  // bounds of them, a hair too large
  M may;
};

// Calls meet(first, candidates) of triangles that turn to the eye (or do not, if backs count too) and that rays of a
// pencil may meet: at least of all that they do meet. Ends when that returns true.
template <bool kBackToo>
class Sifter {
 public:
  Sifter(const Mesh& mesh, const Sight& sight, const Pencil& pencil)
      : mesh_(mesh), sight_(sight), pencil_(pencil), sides_(mesh, sight, pencil) {
    rounded_ = 0;
    for (int k = 0; k < 3 && sight.parallel; ++k) rounded_ += 1e-6F * (std::abs(sight.o[k]) + mesh.half[k]);
  }

  template <class Meet>
  HWY_INLINE void each(const Meet& meet) const {
    if (mesh_.branches.empty()) return;
    const int lanes = static_cast<int>(hn::Lanes(D()));
    std::int32_t stack[Mesh::kStack];
    int depth = 0;
    stack[depth++] = 0;
    bool end = false;
    while (depth > 0 && !end) {
      const Branch& branch = mesh_.branches[static_cast<std::size_t>(stack[--depth])];
      for (int first = 0; first < branch.count; first += lanes) {
        const M may = sides_.template may_meet<kBackToo>(branch, first);
        EachLane(may, [&](int lane) {
          const int i = first + lane;
          if (branch.branch[i] != 0) {
            stack[depth++] = branch.branch[i];
            hwy::Prefetch(&mesh_.branches[static_cast<std::size_t>(branch.branch[i])]);
          } else {
            const Triangles::Block& block = block_of(branch.first[i]);
            for (int k = 0; k < 9; ++k) hwy::Prefetch(block.number[k]);
          }
        });
        EachLane(may, [&](int lane) {
          const int i = first + lane;
          if (branch.branch[i] == 0 && !end) end = sift(branch.first[i], branch.triangles[i], meet);
        });
      }
    }
  }

 private:
  HWY_INLINE const Triangles::Block& block_of(int first) const {
    return mesh_.triangles.block(static_cast<std::size_t>(first) / Triangles::kBlock);
  }

  template <class Meet>
  HWY_INLINE bool sift(int first, int count, const Meet& meet) const {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    const Triangles::Block& block = block_of(first);
    for (int i = 0; i < count; i += lanes) {
      Candidates found;
      for (int k = 0; k < 9; ++k) found.number[k] = Load(block.number[k] + i);
      found.may = hn::FirstN(D(), static_cast<std::size_t>(count - i));
      if (outline(found) && meet(first + i, found)) return true;
    }
    return false;
  }

  // Whether any of these may be met.
  HWY_INLINE bool outline(Candidates& found) const {
    const auto three = [&](int k) { return V3{found.number[k], found.number[k + 1], found.number[k + 2]}; };
    const V3 e1 = three(3);
    const V3 e2 = three(6);
    V3 q[3];
    q[0] = three(0) - Set(sight_.o);
    q[1] = q[0] + e1;
    q[2] = q[0] + e2;
    M may = found.may;
    if (!kBackToo) {
      const V3 n = Cross(e1, e2);
      const V edgeways = Set(1e-9F) * Dot(q[0], q[0]) * Dot(n, n);
      const V away = Dot(q[0], n);
      may = hn::And(may, hn::Or(hn::Le(away, Zero()), hn::Le(away * away, edgeways)));
      if (None(may)) return false;
    }
    V nearest = Dot(q[0], Set(sight_.ahead));
    V farthest = nearest;
    V low[2] = {Set(kMiss), Set(kMiss)};
    V high[2] = {Set(-kMiss), Set(-kMiss)};
    for (int corner = 0; corner < 3; ++corner) {
      const V z = Dot(q[corner], Set(sight_.ahead));
      const V over = sight_.parallel ? Set(1.0F) : Set(1.0F) / hn::Max(z, Set(1e-20F));
      const V x = Dot(q[corner], Set(sight_.right)) * over;
      const V y = Dot(q[corner], Set(sight_.up)) * over;
      found.at[corner][0] = x;
      found.at[corner][1] = y;
      nearest = hn::Min(nearest, z);
      farthest = hn::Max(farthest, z);
      low[0] = hn::Min(low[0], x);
      low[1] = hn::Min(low[1], y);
      high[0] = hn::Max(high[0], x);
      high[1] = hn::Max(high[1], y);
    }
    // What reaches behind the eye may be anywhere.
    M behind = hn::Lt(Zero(), Zero());
    if (!sight_.parallel) {
      behind = hn::Le(nearest, Set(1e-3F) * hn::Abs(farthest));
      may = hn::And(may, hn::Gt(farthest, Zero()));
    }
    const float end = pencil_.farthest + 1e-5F * std::abs(pencil_.farthest) + rounded_;
    may = hn::And(may, hn::Le(nearest, Set(end)));
    for (int k = 0; k < 2; ++k) {
      const V hair = Set(kHairOfOutline) * (Set(1.0F) + hn::Max(hn::Abs(low[k]), hn::Abs(high[k]))) + Set(rounded_);
      found.low[k] = Pick(behind, Set(-kMiss), low[k] - hair);
      found.high[k] = Pick(behind, Set(kMiss), high[k] + hair);
      may =
          hn::And(may, hn::And(hn::Le(found.low[k], Set(pencil_.high[k])), hn::Ge(found.high[k], Set(pencil_.low[k]))));
    }
    found.may = may;
    return !None(may);
  }

  const Mesh& mesh_;
  const Sight& sight_;
  const Pencil& pencil_;
  const Sides sides_;
  float rounded_;  // of places, where they are looked at instead of slopes
};

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
