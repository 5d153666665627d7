// The normals of meshes at the rays that met them.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_NORMALS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_NORMALS_INL_H
#undef MIMO_RAYS_NORMALS_INL_H
#else
#define MIMO_RAYS_NORMALS_INL_H
#endif

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstdint>

#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/mesh-inl.h"
#include "rays/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// Set where a ray met a mesh.
struct Normals {
  alignas(64) float x[kRays];
  float y[kRays], z[kRays];

  HWY_INLINE V3 at(int i) const { return {Load(x + i), Load(y + i), Load(z + i)}; }
};

// What rays of a tile met.
struct Points {
  const Tile* tile;
  const float* t;
  const std::int32_t* id;
  const std::int32_t* face;
};

// Which lights with shadows are behind points of a surface with these normals, a bit each: they give it nothing.
HWY_INLINE VI Behind(const Lights& lights, int solid, const V3& p, const V3& n) {
  VI away = hn::Zero(DI());
  for (int k = 0; k < lights.count(); ++k) {
    const Light& light = lights[k];
    if (light.caster < 0) continue;
    V3 to_light = Set(lights.at(solid, k).position);
    if (!light.directional) to_light = to_light - p;
    const V along = Dot(n, to_light);
    const M behind = hn::And(hn::Lt(along, Zero()), hn::Gt(along * along, Dot(to_light, to_light) * Set(1e-6F)));
    away = hn::Or(away, hn::IfThenElseZero(hn::RebindMask(DI(), behind), SetI(1 << light.caster)));
  }
  return away;
}

// The normals of a mesh where it was met, and the lights behind them, if that is wanted. The rays are packed: few
// vectors of a tile show one mesh only.
HWY_NOINLINE void FindNormals(const Frame& frame, const Aspect& aspect, int index, const Points& points,
                              const Window& w, Normals& normals, std::int32_t* away) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const Tile& tile = *points.tile;
  std::int32_t rays[kRays + kTile];
  int count = 0;
  for (int row = w.row0; row <= w.row1; ++row) {
    for (int column = w.column0 / lanes * lanes; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      const auto mine = hn::Eq(hn::Load(DI(), points.id + i), SetI(index));
      hn::StoreU(hn::Compress(hn::Iota(DI(), i), mine), DI(), rays + count);
      count += static_cast<int>(hn::CountTrue(DI(), mine));
    }
  }
  if (count == 0) return;
  std::fill_n(rays + count, lanes, rays[0]);  // beyond the last: once more
  const Mesh& mesh = *frame.solids[aspect.solid].mesh;
  const auto fetch = [&](int from, int to) {
    for (int k = from; k < std::min(to, count); ++k) {
      const float* const surface = mesh.surfaces[static_cast<std::size_t>(points.face[rays[k]])].corner.data();
      hwy::Prefetch(surface);
      hwy::Prefetch(surface + kSurfaceFloats - 1);
    }
  };
  constexpr int kAhead = 2 * kTile;
  fetch(0, kAhead);
  for (int k = 0; k < count; k += lanes) {
    fetch(k + kAhead, k + kAhead + lanes);
    const VI i = hn::LoadU(DI(), rays + k);
    const V x = FindSlope(tile.x, hn::And(i, SetI(kTile - 1)));
    const V y = FindSlope(tile.y, hn::ShiftRight<4>(i));
    const Ray ray = RayAcross(aspect, tile, Set(aspect.a) + Set(aspect.by) * y + Set(aspect.bx) * x);
    const V3 p = ray.o + ray.d * hn::GatherIndex(D(), points.t, i);
    const V3 n = SurfaceAt<Known::kNormals>(mesh, hn::GatherIndex(DI(), points.face, i), p).normal();
    hn::ScatterIndex(n.x, D(), normals.x, i);
    hn::ScatterIndex(n.y, D(), normals.y, i);
    hn::ScatterIndex(n.z, D(), normals.z, i);
    if (away != nullptr) hn::ScatterIndex(Behind(frame.lights, aspect.solid, p, n), DI(), away, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
