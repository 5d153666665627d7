// The triangles of a mesh that many rays from one point may meet: boxes are looked at once for all of these rays, and
// of many triangles at a time those are left out that none can meet.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_PENCIL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_PENCIL_INL_H
#undef MIMO_RAYS_PENCIL_INL_H
#else
#define MIMO_RAYS_PENCIL_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rays/camera.h"
#include "rays/lanes-inl.h"
#include "rays/meshes.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// Rays from an eye whose slopes lie within these bounds, as far as something may be met.
struct Pencil {
  float low[2], high[2];
  float farthest;
};

// Bounds of a triangle's slopes.
struct Outline {
  float low[2], high[2];
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
        normal_[k][i] = n;
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
    for (int i = 6; i < kPlaces; ++i) put(i, 0, 0, 0, 1);
  }

  HWY_INLINE bool may_meet(const Node& node) const {
    const P d;
    for (int i = 0; i < kPlaces; i += static_cast<int>(hn::Lanes(d))) {
      auto most = hn::Load(d, distance_ + i);
      for (int k = 0; k < 3; ++k) {
        const auto n = hn::Load(d, normal_[k] + i);
        most = most + hn::Max(n * hn::Set(d, node.low[k]), n * hn::Set(d, node.high[k]));
      }
      if (!hn::AllTrue(d, hn::Ge(most, hn::Zero(d)))) return false;
    }
    return true;
  }

 private:
  static constexpr int kPlaces = 8;
  using P = hn::CappedTag<float, kPlaces>;

  alignas(64) float normal_[3][kPlaces];
  alignas(64) float distance_[kPlaces];
};

// Calls meet(index, outline) of triangles that turn to the eye and that rays of a pencil may meet: at least of all that
// they do meet. An outline is a hair too large.
class Sifter {
 public:
  Sifter(const Mesh& mesh, const Aspect& aspect, const Pencil& pencil)
      : mesh_(mesh), aspect_(aspect), pencil_(pencil), sides_(mesh, aspect, pencil) {}

  template <class Meet>
  HWY_INLINE void each(const Meet& meet) const {
    if (mesh_.nodes.empty()) return;
    std::int32_t stack[Mesh::kDepth];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = mesh_.nodes[static_cast<std::size_t>(stack[--depth])];
      if (!sides_.may_meet(node)) continue;
      if (node.count > kMany && node.child != 0) {
        stack[depth++] = node.child + 1;
        stack[depth++] = node.child;
        continue;
      }
      const int lanes = static_cast<int>(hn::Lanes(D()));
      for (int i = 0; i < node.count; i += lanes) sift(node.first + i, node.count - i, meet);
    }
  }

 private:
  static constexpr int kMany = 16;  // triangles that are looked at without their own boxes

  HWY_INLINE V3 three(int k, int first) const {
    static_assert(Triangles::kBeyond >= hn::MaxLanes(D()), "a vector may reach beyond the last triangle");
    const auto get = [&](int i) { return hn::LoadU(D(), mesh_.triangles.number(i, static_cast<std::size_t>(first))); };
    return {get(k), get(k + 1), get(k + 2)};
  }

  template <class Meet>
  HWY_INLINE void sift(int first, int count, const Meet& meet) const {
    const V3 e1 = three(3, first);
    const V3 e2 = three(6, first);
    V3 q[3];
    q[0] = three(0, first) - Set(aspect_.o);
    q[1] = q[0] + e1;
    q[2] = q[0] + e2;
    const int lanes = static_cast<int>(hn::Lanes(D()));
    M may = hn::FirstN(D(), static_cast<std::size_t>(std::min(count, lanes)));
    const V3 n = Cross(e1, e2);
    const V edgeways = Set(1e-9F) * Dot(q[0], q[0]) * Dot(n, n);
    const V away = Dot(q[0], n);
    may = hn::And(may, hn::Or(hn::Le(away, Zero()), hn::Le(away * away, edgeways)));
    if (None(may)) return;
    V nearest = Dot(q[0], Set(aspect_.a));
    V farthest = nearest;
    V low[2] = {Set(kMiss), Set(kMiss)};
    V high[2] = {Set(-kMiss), Set(-kMiss)};
    for (int corner = 0; corner < 3; ++corner) {
      const V z = Dot(q[corner], Set(aspect_.a));
      const V over = Set(1.0F) / hn::Max(z, Set(1e-20F));
      const V x = Dot(q[corner], Set(aspect_.bx)) * over;
      const V y = Dot(q[corner], Set(aspect_.by)) * over;
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
    alignas(64) float bounds[4][hn::MaxLanes(D())];
    for (int k = 0; k < 2; ++k) {
      const V hair = Set(1e-5F) * (Set(1.0F) + hn::Max(hn::Abs(low[k]), hn::Abs(high[k])));
      low[k] = Pick(behind, Set(-kMiss), low[k] - hair);
      high[k] = Pick(behind, Set(kMiss), high[k] + hair);
      may = hn::And(may, hn::And(hn::Le(low[k], Set(pencil_.high[k])), hn::Ge(high[k], Set(pencil_.low[k]))));
      Store(low[k], bounds[k]);
      Store(high[k], bounds[2 + k]);
    }
    if (None(may)) return;
    alignas(64) std::int32_t wanted[hn::MaxLanes(D())];
    hn::Store(hn::IfThenElseZero(hn::RebindMask(DI(), may), SetI(1)), DI(), wanted);
    for (int i = 0; i < lanes; ++i) {
      if (wanted[i] != 0) meet(first + i, Outline{{bounds[0][i], bounds[1][i]}, {bounds[2][i], bounds[3][i]}});
    }
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
