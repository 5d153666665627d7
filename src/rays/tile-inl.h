// The rays of one tile, cast at one solid after the other.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_TILE_INL_H
#undef MIMO_RAYS_TILE_INL_H
#else
#define MIMO_RAYS_TILE_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "rays/camera.h"
#include "rays/intersect-inl.h"
#include "rays/lanes-inl.h"
#include "rays/mesh_cast-inl.h"
#include "rays/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

void FindDepths(Tile& tile) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  V least = Set(kMiss);
  V most = Set(-kMiss);
  for (int i = 0; i < kRays; i += lanes) {
    const V t = Load(tile.t + i);
    least = hn::Min(least, t);
    most = hn::Max(most, Pick(hn::Lt(t, Set(kMiss)), t, Set(-kMiss)));
  }
  tile.nearest = hn::GetLane(hn::MinOfLanes(D(), least));
  tile.farthest = hn::GetLane(hn::MaxOfLanes(D(), most));
}

// What lies in one place, for what is rounded of its depth.
constexpr float kOnePlace = 2e-6F;

// Of two solids in one place OpenGL shows the one that MuJoCo draws last: the later one, and a transparent one after
// all that are opaque. (Of transparent ones, those that were met first are drawn last.)
inline bool IsDrawnAfter(const Solids& solids, const Eye& eye, int index, std::int32_t other) {
  if (other < 0) return true;
  const int one = eye.aspects[index].solid, two = eye.aspects[other].solid;
  return solids[one].transparent ? !solids[two].transparent : one > two;
}

// Of rays that meet a solid where they met another one before, those that show it.
HWY_NOINLINE M ShownOf(M met, const Solids& solids, const Eye& eye, int index, const std::int32_t* id) {
  alignas(64) std::int32_t shown[hn::MaxLanes(D())] = {};
  EachLane(met, [&](int lane) { shown[lane] = IsDrawnAfter(solids, eye, index, id[lane]) ? 1 : 0; });
  return hn::RebindMask(D(), hn::Gt(hn::Load(DI(), shown), hn::Zero(DI())));
}

// Casts the tile's rays at one solid. `from` is the depth from which on it is seen: for all rays, or for each.
template <Form kKind, bool kFromEach>
HWY_NOINLINE void CastAt(const Solids& solids, const Eye& eye, int index, const Tile& tile, const Window& w,
                         const float* from, float* HWY_RESTRICT best, std::int32_t* HWY_RESTRICT id) {
  const Aspect& aspect = eye.aspects[index];
  const Solid& solid = solids[aspect.solid];
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const int first = w.column0 / lanes * lanes;
  const V3 bx = Set(aspect.bx);
  const VI index_v = hn::Set(DI(), index);
  for (int row = w.row0; row <= w.row1; ++row) {
    const float y = tile.y[row];
    const V3 base = {Set(aspect.a[0] + y * aspect.by[0]), Set(aspect.a[1] + y * aspect.by[1]),
                     Set(aspect.a[2] + y * aspect.by[2])};
    for (int column = first; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      const Ray ray = RayAcross(aspect, tile, base + bx * Load(tile.x + column));
      const V old = Load(best + i);
      const V start = kFromEach ? Load(from + i) : Set(*from);
      const V t = Enter<kKind>(solid, ray);
      const V beyond = hn::Min(old * Set(1 + kOnePlace), Set(kMiss));
      M seen = hn::And(hn::Lt(t, beyond), hn::Ge(t, start));
      if (None(seen)) continue;
      const M there = hn::And(seen, hn::Ge(t, old * Set(1 - kOnePlace)));
      if (!None(there)) seen = hn::Or(hn::AndNot(there, seen), ShownOf(there, solids, eye, index, id + i));
      Store(Pick(seen, t, old), best + i);
      const VI old_id = hn::Load(DI(), id + i);
      hn::Store(hn::IfThenElse(hn::RebindMask(DI(), seen), index_v, old_id), DI(), id + i);
    }
  }
}

template <bool kFromEach>
void Cast(const Solids& solids, const Eye& eye, int index, const Tile& tile, const Window& w, const float* from,
          float* best, std::int32_t* id, std::int32_t* face) {
  const auto cast = [&](auto kind) {
    CastAt<decltype(kind)::value, kFromEach>(solids, eye, index, tile, w, from, best, id);
  };
  const Aspect& aspect = eye.aspects[index];
  const Solid& solid = solids[aspect.solid];
  switch (solid.kind) {
    case Form::kPlane: cast(FormTag<Form::kPlane>()); break;
    case Form::kSphere: cast(FormTag<Form::kSphere>()); break;
    case Form::kCapsule: cast(FormTag<Form::kCapsule>()); break;
    case Form::kEllipsoid: cast(FormTag<Form::kEllipsoid>()); break;
    case Form::kCylinder: cast(FormTag<Form::kCylinder>()); break;
    case Form::kBox: cast(FormTag<Form::kBox>()); break;
    case Form::kMesh: CastAtMesh<kFromEach>(*solid.mesh, aspect, index, tile, w, from, {best, id, face}); break;
  }
}

// Forgets what the rays have met.
inline void StartTile(const Solids& solids, Tile& tile) {
  const auto fill = [](const auto& d, auto value, auto* to) {
    for (int i = 0; i < kRays; i += static_cast<int>(hn::Lanes(d))) hn::Store(hn::Set(d, value), d, to + i);
  };
  fill(D(), kMiss, tile.t);
  fill(DI(), -1, tile.id);
  if (!solids.meshes()) return;
  fill(DI(), 0, tile.face);
  fill(DI(), 0, tile.away);
}

// Where the rays of a tile meet the solid that one of the camera's aspects shows.
inline void Meet(const Solids& solids, const Camera& camera, int index, Tile& tile) {
  const Window w = WindowOf(camera.aspects[index], tile);
  if (!IsEmpty(w)) Cast<false>(solids, camera, index, tile, w, &camera.near_plane, tile.t, tile.id, tile.face);
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
