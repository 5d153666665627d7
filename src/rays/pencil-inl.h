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

// Rays from an eye whose slopes lie within these bounds, as far as something may be met.
struct Pencil {
  float low[2], high[2];
  float farthest;
};

// The sides of a pencil, in the frame of a mesh: planes that have it before them.
class Sides {
 public:
  Sides(const Mesh& mesh, const Aspect& aspect, const Pencil& pencil) {
    const auto put = [&](int i, float along_x, float along_y, float along_z, float from) {
      float size = std::abs(from);
      distance_[i] = from;
      for (int k = 0; k < 3; ++k) {
        const float n = along_x * aspect.bx[k] + along_y * aspect.by[k] + along_z * aspect.a[k];
        normal_[i][k] = n;
        distance_[i] -= n * aspect.o[k];
        size += std::abs(n) * (std::abs(aspect.o[k]) + mesh.half[k]);
      }
      distance_[i] += 1e-5F * size;  // for what is rounded
    };
    put(0, 1, 0, -pencil.low[0], 0);
    put(1, -1, 0, pencil.high[0], 0);
    put(2, 0, 1, -pencil.low[1], 0);
    put(3, 0, -1, pencil.high[1], 0);
    put(4, 0, 0, 1, 0);
    put(5, 0, 0, -1, pencil.farthest);
  }

  // The boxes `first` and following that rays of the pencil may meet.
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
    return may;
  }

 private:
  static constexpr int kSides = 6;

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

// Calls meet(first, candidates) of triangles that turn to the eye and that rays of a pencil may meet: at least of all
// that they do meet.
class Sifter {
 public:
  Sifter(const Mesh& mesh, const Aspect& aspect, const Pencil& pencil)
      : mesh_(mesh), aspect_(aspect), pencil_(pencil), sides_(mesh, aspect, pencil) {}

  template <class Meet>
  HWY_INLINE void each(const Meet& meet) const {
    if (mesh_.branches.empty()) return;
    const int lanes = static_cast<int>(hn::Lanes(D()));
    std::int32_t stack[Mesh::kStack];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Branch& branch = mesh_.branches[static_cast<std::size_t>(stack[--depth])];
      for (int first = 0; first < branch.count; first += lanes) {
        const M may = sides_.may_meet(branch, first);
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
          if (branch.branch[i] == 0) sift(branch.first[i], branch.triangles[i], meet);
        });
      }
    }
  }

 private:
  HWY_INLINE const Triangles::Block& block_of(int first) const {
    return mesh_.triangles.block(static_cast<std::size_t>(first) / Triangles::kBlock);
  }

  template <class Meet>
  HWY_INLINE void sift(int first, int count, const Meet& meet) const {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    const Triangles::Block& block = block_of(first);
    for (int i = 0; i < count; i += lanes) {
      Candidates found;
      for (int k = 0; k < 9; ++k) found.number[k] = Load(block.number[k] + i);
      found.may = hn::FirstN(D(), static_cast<std::size_t>(count - i));
      if (outline(found)) meet(first + i, found);
    }
  }

  // Whether any of these may be met.
  HWY_INLINE bool outline(Candidates& found) const {
    const auto three = [&](int k) { return V3{found.number[k], found.number[k + 1], found.number[k + 2]}; };
    const V3 e1 = three(3);
    const V3 e2 = three(6);
    V3 q[3];
    q[0] = three(0) - Set(aspect_.o);
    q[1] = q[0] + e1;
    q[2] = q[0] + e2;
    M may = found.may;
    const V3 n = Cross(e1, e2);
    const V edgeways = Set(1e-9F) * Dot(q[0], q[0]) * Dot(n, n);
    const V away = Dot(q[0], n);
    may = hn::And(may, hn::Or(hn::Le(away, Zero()), hn::Le(away * away, edgeways)));
    if (None(may)) return false;
    V nearest = Dot(q[0], Set(aspect_.a));
    V farthest = nearest;
    V low[2] = {Set(kMiss), Set(kMiss)};
    V high[2] = {Set(-kMiss), Set(-kMiss)};
    for (int corner = 0; corner < 3; ++corner) {
      const V z = Dot(q[corner], Set(aspect_.a));
      const V over = Set(1.0F) / hn::Max(z, Set(1e-20F));
      const V x = Dot(q[corner], Set(aspect_.bx)) * over;
      const V y = Dot(q[corner], Set(aspect_.by)) * over;
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
    const M behind = hn::Le(nearest, Set(1e-3F) * hn::Abs(farthest));
    may = hn::And(may, hn::And(hn::Gt(farthest, Zero()), hn::Le(nearest, Set(pencil_.farthest * (1 + 1e-5F)))));
    for (int k = 0; k < 2; ++k) {
      const V hair = Set(kHairOfOutline) * (Set(1.0F) + hn::Max(hn::Abs(low[k]), hn::Abs(high[k])));
      found.low[k] = Pick(behind, Set(-kMiss), low[k] - hair);
      found.high[k] = Pick(behind, Set(kMiss), high[k] + hair);
      may =
          hn::And(may, hn::And(hn::Le(found.low[k], Set(pencil_.high[k])), hn::Ge(found.high[k], Set(pencil_.low[k]))));
    }
    found.may = may;
    return !None(may);
  }

  const Mesh& mesh_;
  const Aspect& aspect_;
  const Pencil& pencil_;
  const Sides sides_;
};

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
