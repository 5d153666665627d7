// Which points of a tile a mesh keeps a light from.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_MESH_SHADOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_MESH_SHADOWS_INL_H
#undef MIMO_RAYS_MESH_SHADOWS_INL_H
#else
#define MIMO_RAYS_MESH_SHADOWS_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "rays/lanes-inl.h"
#include "rays/lights.h"
#include "rays/mesh-inl.h"
#include "rays/pencil-inl.h"
#include "rays/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// How far a mesh is out of its own shadow, relative to its size.
constexpr float kMeshMargin = 1e-3F;
// How much of the way to a light need not be free.
constexpr float kRest = 2e-5F;

// The rays from a light to points in its frame, in the frame of a solid.
template <Rays kRaysKind>
HWY_INLINE Ray ToLight(const Aspect& aspect, V u, V v, V w) {
  const V3 a = Set(aspect.a);
  const V3 bx = Set(aspect.bx);
  const V3 by = Set(aspect.by);
  const V3 o = Set(aspect.o);
  if (kRaysKind == Rays::kPerspective) return {o, a + bx * u + by * v};
  if (kRaysKind == Rays::kParallel) return {a + bx * u + by * v, o};
  return {o, a * w + bx * u + by * v};
}

// Where they end, but for a part of the way.
template <Rays kRaysKind>
HWY_INLINE V BeforeEnd(V end, float rest) {
  if (kRaysKind != Rays::kParallel) return end * Set(1 - rest);
  return end - Set(0.5F * rest) * hn::Abs(end) - Set(0.5F * rest);
}

constexpr int kPatch = 4;  // rays along both sides of what is looked at together

// The points of a tile in a light's frame, and how far they are lit.
struct LightPoints {
  const float *u, *v, *w;
  float* lit;
};

// Rays from a light to the points of a patch, in the frame of a mesh.
struct PatchRays {
  static constexpr int kCount = kPatch * kPatch;

  alignas(64) std::int32_t at[kCount];  // in the tile
  alignas(64) float o[3][kCount];
  alignas(64) float d[3][kCount];
  alignas(64) float limit[kCount];  // what is met before that is in the way; -kMiss where nothing is asked any more
  float from;                       // nor does it count before that

  HWY_INLINE Ray ray(int i) const {
    return {{Load(o[0] + i), Load(o[1] + i), Load(o[2] + i)}, {Load(d[0] + i), Load(d[1] + i), Load(d[2] + i)}};
  }
  // Nothing more is asked of those; whether anything is.
  HWY_INLINE void answer(int i, M met) { Store(Pick(met, Set(-kMiss), Load(limit + i)), limit + i); }
  HWY_INLINE bool asks() const {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    V most = Set(-kMiss);
    for (int i = 0; i < kCount; i += lanes) most = hn::Max(most, Load(limit + i));
    return !All(hn::Le(most, Set(-kMiss)));
  }
};

// The points of a patch as numbers for which a light has one origin or direction: slopes or places, and depth.
struct PatchSpread {
  Sight sight;
  Pencil pencil;
  bool narrow;  // there are such numbers, and few triangles between their bounds
};

// How many triangles of a mesh may be between these bounds, about, if they were everywhere alike.
inline float Expected(const Mesh& mesh, const Aspect& aspect, const PatchSpread& spread) {
  float size = 2 * aspect.radius;
  if (!spread.sight.parallel) {
    const std::array<float, 3>& c = aspect.center;
    const float distance = std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
    size = std::min(size / std::max(distance, 1e-6F), 4.0F);
  }
  const Pencil& pencil = spread.pencil;
  const float area = (pencil.high[0] - pencil.low[0]) * (pencil.high[1] - pencil.low[1]);
  return static_cast<float>(mesh.nodes[0].count) * area / (size * size);
}

// An eye that looks from a light around it towards these points; in the light's axes first.
inline Sight Toward(const Aspect& aspect, const float (&middle)[3]) {
  const float length =
      std::max(std::sqrt(middle[0] * middle[0] + middle[1] * middle[1] + middle[2] * middle[2]), 1e-20F);
  const float f[3] = {middle[0] / length, middle[1] / length, middle[2] / length};
  const bool on_x = std::abs(f[0]) < 0.7F;
  float r[3] = {on_x ? 0 : f[2], on_x ? -f[2] : 0, on_x ? f[1] : -f[0]};
  const float across = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  for (float& v : r) v /= std::max(across, 1e-20F);
  const float u[3] = {f[1] * r[2] - f[2] * r[1], f[2] * r[0] - f[0] * r[2], f[0] * r[1] - f[1] * r[0]};
  Sight sight;
  sight.parallel = false;
  sight.o = aspect.o;
  for (int k = 0; k < 3; ++k) {
    const auto turn = [&](const float(&v)[3]) {
      return aspect.bx[k] * v[0] + aspect.by[k] * v[1] + aspect.a[k] * v[2];
    };
    sight.ahead[k] = turn(f);
    sight.right[k] = turn(r);
    sight.up[k] = turn(u);
  }
  return sight;
}

// Bounds of those rays of which something is asked.
template <Rays kRaysKind>
HWY_INLINE PatchSpread SpreadOf(const Mesh& mesh, const Aspect& aspect, const PatchRays& rays,
                                const LightPoints& points) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  PatchSpread spread;
  const auto bound = [&](const auto& of, float& least, float& most) {
    V low = Set(kMiss);
    V high = Set(-kMiss);
    for (int i = 0; i < PatchRays::kCount; i += lanes) {
      const M asked = hn::Gt(Load(rays.limit + i), Set(-kMiss));
      const V v = of(i);
      low = hn::Min(low, Pick(asked, v, low));
      high = hn::Max(high, Pick(asked, v, high));
    }
    least = hn::GetLane(hn::MinOfLanes(D(), low));
    most = hn::GetLane(hn::MaxOfLanes(D(), high));
  };
  const auto given = [&](const float* of) {
    return [&rays, of](int i) { return hn::GatherIndex(D(), of, hn::Load(DI(), rays.at + i)); };
  };
  Pencil& pencil = spread.pencil;
  float nearest;
  if (kRaysKind != Rays::kAround) {
    spread.sight = SightOf(aspect, kRaysKind == Rays::kParallel);
    bound(given(points.u), pencil.low[0], pencil.high[0]);
    bound(given(points.v), pencil.low[1], pencil.high[1]);
    bound(given(points.w), nearest, pencil.farthest);
    spread.narrow = true;
  } else {
    float middle[3];
    const float* const of[3] = {points.u, points.v, points.w};
    for (int k = 0; k < 3; ++k) {
      float low, high;
      bound(given(of[k]), low, high);
      middle[k] = 0.5F * (low + high);
    }
    spread.sight = Toward(aspect, middle);
    // The rays are as long as the way to the point.
    const auto along = [&](const std::array<float, 3>& axis) {
      return [&rays, &axis](int i) { return Dot(rays.ray(i).d, Set(axis)); };
    };
    const auto slope = [&](const std::array<float, 3>& axis) {
      return [&rays, &axis, ahead = along(spread.sight.ahead)](int i) {
        return Dot(rays.ray(i).d, Set(axis)) / hn::Max(ahead(i), Set(1e-20F));
      };
    };
    bound(along(spread.sight.ahead), nearest, pencil.farthest);
    bound(slope(spread.sight.right), pencil.low[0], pencil.high[0]);
    bound(slope(spread.sight.up), pencil.low[1], pencil.high[1]);
    spread.narrow = nearest > 0.1F * pencil.farthest;
  }
  // For what is rounded.
  pencil.farthest += 1e-5F * std::abs(pencil.farthest);
  for (int k = 0; k < 2; ++k) {
    const float hair = 1e-6F * (1 + std::max(std::abs(pencil.low[k]), std::abs(pencil.high[k])));
    pencil.low[k] -= hair;
    pencil.high[k] += hair;
  }
  constexpr float kFew = 48;  // more are looked for faster by each vector of rays
  spread.narrow = spread.narrow && Expected(mesh, aspect, spread) < kFew;
  return spread;
}

// Answers what a patch asks of a mesh.
HWY_NOINLINE void Ask(const Mesh& mesh, const PatchSpread& spread, PatchRays& rays) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  if (!spread.narrow) {
    for (int i = 0; i < PatchRays::kCount; i += lanes) {
      const V limit = Load(rays.limit + i);
      if (All(hn::Le(limit, Set(-kMiss)))) continue;
      rays.answer(i, IsInTheWay(mesh, rays.ray(i), Set(rays.from), limit));
    }
    return;
  }
  Sifter<true>(mesh, spread.sight, spread.pencil).each([&](int first, const Candidates& found) {
    bool met = false;
    EachLane(found.may, [&](int lane) {
      const Triangle triangle = mesh.triangles[static_cast<std::size_t>(first + lane)];
      for (int i = 0; i < PatchRays::kCount; i += lanes) {
        const Ray ray = rays.ray(i);
        const V limit = Load(rays.limit + i);
        V t;
        M hit = Meeting(ray.o, Set(triangle.corner), Set(triangle.edge1), Set(triangle.edge2))
                    .template at<true>(ray.d, hn::Gt(limit, Set(rays.from)), t);
        hit = hn::And(hit, hn::And(hn::Ge(t, Set(rays.from)), hn::Lt(t, limit)));
        if (None(hit)) continue;
        rays.answer(i, hit);
        met = true;
      }
    });
    return met && !rays.asks();
  });
}

// Takes the light from what lies behind a mesh in a band of the tile that begins with the ray `first`.
template <Rays kRaysKind>
HWY_NOINLINE void ShadowOfMesh(const Solid& solid, const Aspect& aspect, const Tile& tile, int first,
                               const LightPoints& points) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  constexpr bool kHasPlace = kRaysKind != Rays::kParallel;
  PatchRays rays;
  rays.from = kHasPlace ? 1e-30F : -kMiss;
  for (int patch = first; patch < first + kTile; patch += kPatch) {
    for (int i = 0; i < PatchRays::kCount; i += lanes) {
      const VI place = hn::Iota(DI(), i);
      const VI at = hn::Add(SetI(patch),
                            hn::Add(hn::And(place, SetI(kPatch - 1)), hn::Mul(hn::ShiftRight<2>(place), SetI(kTile))));
      hn::Store(at, DI(), rays.at + i);
      const V u = hn::GatherIndex(D(), points.u, at);
      const V v = hn::GatherIndex(D(), points.v, at);
      const V w = hn::GatherIndex(D(), points.w, at);
      M asked = hn::Gt(hn::GatherIndex(D(), points.lit, at), Zero());
      if (kRaysKind != Rays::kAround) {
        const M beside = hn::Or(hn::Or(hn::Lt(u, Set(aspect.left)), hn::Gt(u, Set(aspect.right))),
                                hn::Or(hn::Lt(v, Set(aspect.bottom)), hn::Gt(v, Set(aspect.top))));
        asked = hn::AndNot(hn::Or(beside, hn::Lt(w, Set(aspect.nearest))), asked);
      }
      const Ray ray = ToLight<kRaysKind>(aspect, u, v, w);
      // It may shade itself, where what is in the way is not the very point.
      const M own = hn::RebindMask(D(), hn::Eq(hn::GatherIndex(DI(), tile.id, at), SetI(aspect.self)));
      V margin = Set(kMeshMargin * solid.size[0]);
      if (kRaysKind == Rays::kAround) margin = margin * Rsqrt(hn::Max(Dot(ray.d, ray.d), Set(1e-20F)));
      const V end = (kRaysKind == Rays::kAround ? Set(1.0F) : w) - hn::IfThenElseZero(own, margin);
      Store(Pick(asked, BeforeEnd<kRaysKind>(end, kRest), Set(-kMiss)), rays.limit + i);
      const V3* const of[2] = {&ray.o, &ray.d};
      for (int k = 0; k < 2; ++k) {
        float(*to)[PatchRays::kCount] = k == 0 ? rays.o : rays.d;
        Store(of[k]->x, to[0] + i);
        Store(of[k]->y, to[1] + i);
        Store(of[k]->z, to[2] + i);
      }
    }
    if (!rays.asks()) continue;
    alignas(64) float asked[PatchRays::kCount];
    std::copy_n(rays.limit, PatchRays::kCount, asked);
    Ask(*solid.mesh, SpreadOf<kRaysKind>(*solid.mesh, aspect, rays, points), rays);
    for (int i = 0; i < PatchRays::kCount; ++i) {
      if (asked[i] > -kMiss && !(rays.limit[i] > -kMiss)) points.lit[rays.at[i]] = 0;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
