// Which points of a tile a light reaches.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_SHADOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_SHADOWS_INL_H
#undef MIMO_RAYS_SHADOWS_INL_H
#else
#define MIMO_RAYS_SHADOWS_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "rays/frame.h"
#include "rays/intersect-inl.h"
#include "rays/lanes-inl.h"
#include "rays/lights.h"
#include "rays/mesh_shadows-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// Bounds of points in a light's frame: of their slopes for a perspective light, else of their places.
struct Reach {
  float low[3], high[3];
};

// Some rows of a tile, whose points are near each other.
constexpr int kBandRows = 4;
constexpr int kBandRays = kBandRows * kTile;
constexpr int kBands = kTile / kBandRows;
struct Band {
  Reach reach;
  bool lit;  // whether anything in it still is
};

enum class Shadows { kNone, kSome, kAll };

// The points of a tile as a light sees them, and how far they are lit. All but `of_all` is set where there are some.
struct Shade {
  alignas(64) float u[kRays];
  float v[kRays];
  float w[kRays];  // depth; negative where there is nothing to light
  float lit[kRays];
  Band bands[kBands];
  Shadows of_all;
};

HWY_INLINE V LitAt(const Shade& shade, int i) {
  if (shade.of_all == Shadows::kSome) return Load(shade.lit + i);
  return Set(shade.of_all == Shadows::kNone ? 1.0F : 0.0F);
}

// Which points a convex solid keeps the light from, where it is in the way before so much of the way is left. It does
// not shade itself: `own` are those of its own surface.
template <Form kKind, Rays kRaysKind>
HWY_INLINE M IsBehind(const Solid& solid, const Aspect& aspect, V u, V v, V w, M own, float rest) {
  const V limit = BeforeEnd<kRaysKind>(kRaysKind == Rays::kAround ? Set(1.0F) : w, rest);
  const V t = Enter<kKind>(solid, ToLight<kRaysKind>(aspect, u, v, w));
  const M before = hn::Lt(t, limit);
  return hn::AndNot(own, kRaysKind == Rays::kParallel ? before : hn::And(hn::Gt(t, Zero()), before));
}

// Takes the light from what lies behind a solid in a band of the tile that begins with the ray `first`; whether
// anything there is still lit.
template <Form kKind, Rays kRaysKind>
HWY_NOINLINE bool ShadowAt(const Solid& solid, const Aspect& aspect, const Tile& tile, int first, Shade& shade) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const VI self = hn::Set(DI(), aspect.self);
  V any = Zero();
  for (int i = first; i < first + kBandRays; i += lanes) {
    const V u = Load(shade.u + i);
    const V v = Load(shade.v + i);
    const V w = Load(shade.w + i);
    const V lit = Load(shade.lit + i);
    if (All(hn::Eq(lit, Zero()))) continue;
    if (kRaysKind != Rays::kAround) {
      const M beside = hn::Or(hn::Or(hn::Lt(u, Set(aspect.left)), hn::Gt(u, Set(aspect.right))),
                              hn::Or(hn::Lt(v, Set(aspect.bottom)), hn::Gt(v, Set(aspect.top))));
      if (All(hn::Or(beside, hn::Lt(w, Set(aspect.nearest))))) {
        any = hn::Max(any, lit);
        continue;
      }
    }
    const M own = hn::RebindMask(D(), hn::Eq(hn::Load(DI(), tile.id + i), self));
    const M dark = IsBehind<kKind, kRaysKind>(solid, aspect, u, v, w, own, kRest);
    const V left = hn::IfThenZeroElse(dark, lit);
    any = hn::Max(any, left);
    Store(left, shade.lit + i);
  }
  return !All(hn::Eq(any, Zero()));
}

template <Rays kRaysKind>
bool Shadow(const Solid& solid, const Aspect& aspect, const Tile& tile, int first, Shade& shade) {
  switch (solid.kind) {
    case Form::kPlane: return ShadowAt<Form::kPlane, kRaysKind>(solid, aspect, tile, first, shade);
    case Form::kSphere: return ShadowAt<Form::kSphere, kRaysKind>(solid, aspect, tile, first, shade);
    case Form::kCapsule: return ShadowAt<Form::kCapsule, kRaysKind>(solid, aspect, tile, first, shade);
    case Form::kEllipsoid: return ShadowAt<Form::kEllipsoid, kRaysKind>(solid, aspect, tile, first, shade);
    case Form::kCylinder: return ShadowAt<Form::kCylinder, kRaysKind>(solid, aspect, tile, first, shade);
    case Form::kBox: return ShadowAt<Form::kBox, kRaysKind>(solid, aspect, tile, first, shade);
    case Form::kMesh:
      ShadowOfMesh<kRaysKind>(solid, aspect, tile, first, {shade.u, shade.v, shade.w, shade.lit});
      return !std::all_of(shade.lit + first, shade.lit + first + kBandRays, [](float lit) { return lit == 0; });
  }
  return true;
}

// Whether a solid may come between the light and points within these bounds.
template <Rays kRaysKind>
bool MayShade(const Aspect& aspect, const Reach& reach) {
  if (kRaysKind != Rays::kAround) {
    return aspect.nearest <= reach.high[2] && aspect.left <= reach.high[0] && aspect.right >= reach.low[0] &&
           aspect.bottom <= reach.high[1] && aspect.top >= reach.low[1];
  }
  // A ball that holds the points, and everything between it and the light.
  float center[3];
  float square = 0;
  float along = 0;
  float radius = 0;
  for (int k = 0; k < 3; ++k) {
    center[k] = 0.5F * (reach.low[k] + reach.high[k]);
    square += center[k] * center[k];
    along += aspect.center[k] * center[k];
    radius += (reach.high[k] - reach.low[k]) * (reach.high[k] - reach.low[k]);
  }
  const float s = square > 0 ? std::min(std::max(along / square, 0.0F), 1.0F) : 0;
  float distance = 0;
  for (int k = 0; k < 3; ++k) distance += (aspect.center[k] - s * center[k]) * (aspect.center[k] - s * center[k]);
  const float both = aspect.radius + 0.5F * std::sqrt(radius);
  return distance <= both * both;
}

// Bounds of all that a tile may show between two depths; false where there are none.
template <Rays kRaysKind>
bool BoundTile(const Caster& light, const Tile& tile, Reach& reach) {
  const float x[2] = {tile.x[0], tile.x[kTile - 1]};
  const float y[2] = {tile.y[0], tile.y[kTile - 1]};
  const float t[2] = {tile.nearest, tile.farthest};
  std::fill_n(reach.low, 3, kMiss);
  std::fill_n(reach.high, 3, -kMiss);
  for (int corner = 0; corner < 8; ++corner) {
    float p[3];
    for (int k = 0; k < 3; ++k) {
      const float aside = light.bx[k] * x[corner & 1] + light.by[k] * y[corner >> 1 & 1], far = t[corner >> 2 & 1];
      p[k] = light.o[k] + (tile.parallel ? light.a[k] * far + aside : (light.a[k] + aside) * far);
    }
    if (kRaysKind == Rays::kPerspective) {
      if (p[2] < 1e-4F) return false;
      p[0] /= p[2];
      p[1] /= p[2];
    }
    for (int k = 0; k < 3; ++k) {
      reach.low[k] = std::min(reach.low[k], p[k]);
      reach.high[k] = std::max(reach.high[k], p[k]);
    }
  }
  for (int k = 0; k < 3; ++k) {  // for what is rounded
    const float slack = 1e-4F * (1 + std::max(std::abs(reach.low[k]), std::abs(reach.high[k])));
    reach.low[k] -= slack;
    reach.high[k] += slack;
  }
  return true;
}

// A band's points in the light's frame, all of them lit, and their bounds. (Behind a spotlight nothing is lit, nor what
// turns away from a light: `behind` is its bit where there are meshes.)
template <Rays kRaysKind>
HWY_INLINE void PlacePoints(const Caster& light, const Tile& tile, int first, int behind, Shade& shade, Band& band) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 a = Set(light.a);
  const V3 bx = Set(light.bx);
  const V3 o = Set(light.o);
  const V big = Set(kMiss);
  V3 low = {big, big, big};
  V3 high = low * Set(-1.0F);
  const V3 lowest = high;
  for (int i = first; i < first + kBandRays; i += lanes) {
    const V3 base = a + Set(light.by) * Set(tile.y[i / kTile]);
    const V3 across = base + bx * Load(tile.x + i % kTile);
    const V t = Load(tile.t + i);
    V3 p = tile.parallel ? o + across + a * (t - Set(1.0F)) : o + across * t;
    M valid = hn::RebindMask(D(), hn::Gt(hn::Load(DI(), tile.id + i), SetI(-1)));
    if (behind != 0) {
      const VI away = hn::And(hn::Load(DI(), tile.away + i), SetI(behind));
      valid = hn::And(valid, hn::RebindMask(D(), hn::Eq(away, hn::Zero(DI()))));
    }
    if (kRaysKind == Rays::kPerspective) {
      valid = hn::And(valid, hn::Gt(p.z, Zero()));
      const V over = Set(1.0F) / p.z;
      p.x = p.x * over;
      p.y = p.y * over;
    }
    const V3 least = Pick(valid, p, V3{big, big, big});
    const V3 most = Pick(valid, p, lowest);
    Store(p.x, shade.u + i);
    Store(p.y, shade.v + i);
    Store(most.z, shade.w + i);
    Store(hn::IfThenElseZero(valid, Set(1.0F)), shade.lit + i);
    low = {hn::Min(low.x, least.x), hn::Min(low.y, least.y), hn::Min(low.z, least.z)};
    high = {hn::Max(high.x, most.x), hn::Max(high.y, most.y), hn::Max(high.z, most.z)};
  }
  const V lows[3] = {low.x, low.y, low.z};
  const V highs[3] = {high.x, high.y, high.z};
  for (int k = 0; k < 3; ++k) {
    band.reach.low[k] = hn::GetLane(hn::MinOfLanes(D(), lows[k]));
    band.reach.high[k] = hn::GetLane(hn::MaxOfLanes(D(), highs[k]));
  }
  band.lit = band.reach.low[0] <= band.reach.high[0];
}

// Bounds of all bands; false if nothing is lit.
inline bool Unite(const Band (&bands)[kBands], Reach& reach) {
  reach = bands[0].reach;
  bool lit = bands[0].lit;
  for (int k = 1; k < kBands; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      reach.low[axis] = std::min(reach.low[axis], bands[k].reach.low[axis]);
      reach.high[axis] = std::max(reach.high[axis], bands[k].reach.high[axis]);
    }
    lit = lit || bands[k].lit;
  }
  return lit;
}

template <Rays kRaysKind>
void CastShadows(const Solids& solids, const Caster& light, int behind, const Tile& tile, Shade& shade) {
  for (int k = 0; k < kBands; ++k) PlacePoints<kRaysKind>(light, tile, k * kBandRays, behind, shade, shade.bands[k]);
  Reach reach;
  bool lit = Unite(shade.bands, reach);
  const Aspect* const end = light.aspects.data() + light.count;
  for (const Aspect* aspect = light.aspects.data(); lit && aspect < end; ++aspect) {
    if (!MayShade<kRaysKind>(*aspect, reach)) continue;
    lit = false;
    for (int k = 0; k < kBands; ++k) {
      Band& band = shade.bands[k];
      if (band.lit && MayShade<kRaysKind>(*aspect, band.reach)) {
        band.lit = Shadow<kRaysKind>(solids[aspect->solid], *aspect, tile, k * kBandRays, shade);
      }
      lit = lit || band.lit;
    }
  }
}

// The corners of a tile on a plane, a hair outside of it, so that all of the tile is between them.
struct FlatTile {
  static constexpr int kPoints = kTile;  // four, again and again: no fewer than a vector has
  const Tile& tile;
  const Aspect& plane;

  template <Rays kRaysKind>
  void place(const Caster& light, float (&points)[3][kPoints]) const {
    const auto slope = [](const float* v, float step, bool last) {
      return last ? v[kTile - 1] + 0.02F * step : v[0] - 0.02F * step;
    };
    for (int i = 0; i < kPoints; ++i) {
      const float x = slope(tile.x, tile.dx, (i & 1) != 0);
      const float y = slope(tile.y, tile.dy, (i & 2) != 0);
      const float t = -plane.o[2] / (plane.a[2] + plane.by[2] * y + plane.bx[2] * x);
      for (int k = 0; k < 3; ++k) points[k][i] = light.o[k] + (light.a[k] + light.by[k] * y + light.bx[k] * x) * t;
      if (kRaysKind != Rays::kPerspective) continue;
      points[0][i] /= points[2][i];
      points[1][i] /= points[2][i];
    }
  }
};

// Whether a solid keeps the light from all points: what is convex does if it hides the corners of a flat tile.
template <Rays kRaysKind>
bool HidesAll(const Solid& solid, const Aspect& aspect, const float (&points)[3][FlatTile::kPoints]) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int i = 0; i < 4; i += lanes) {
    const V u = Load(points[0] + i);
    const V v = Load(points[1] + i);
    const V w = Load(points[2] + i);
    const auto hidden = [&](auto form) {
      constexpr Form kKind = decltype(form)::value;
      return IsBehind<kKind, kRaysKind>(solid, aspect, u, v, w, hn::Lt(Zero(), Zero()), 1e-3F);
    };
    bool all = false;
    switch (solid.kind) {
      case Form::kSphere: all = All(hidden(FormTag<Form::kSphere>())); break;
      case Form::kCapsule: all = All(hidden(FormTag<Form::kCapsule>())); break;
      case Form::kEllipsoid: all = All(hidden(FormTag<Form::kEllipsoid>())); break;
      case Form::kCylinder: all = All(hidden(FormTag<Form::kCylinder>())); break;
      case Form::kBox: all = All(hidden(FormTag<Form::kBox>())); break;
      default: break;
    }
    if (!all) return false;
  }
  return true;
}

// Whether a tile lies in a light's shadow: not at all, perhaps, or, of a flat one, all of it.
template <Rays kRaysKind>
Shadows LookForShadows(const Solids& solids, const Caster& light, const Tile& tile, const FlatTile* flat) {
  Reach reach;
  if (!BoundTile<kRaysKind>(light, tile, reach)) return Shadows::kSome;
  alignas(64) float points[3][FlatTile::kPoints];
  bool placed = false;
  Shadows result = Shadows::kNone;
  const Aspect* const end = light.aspects.data() + light.count;
  for (const Aspect* aspect = light.aspects.data(); aspect < end; ++aspect) {
    if (!MayShade<kRaysKind>(*aspect, reach)) continue;
    result = Shadows::kSome;
    if (flat == nullptr) break;
    if (!placed) flat->template place<kRaysKind>(light, points);
    placed = true;
    if (HidesAll<kRaysKind>(solids[aspect->solid], *aspect, points)) return Shadows::kAll;
  }
  return result;
}

void LookForShadows(const Frame& frame, const Tile& tile, const FlatTile* flat, Shade* shades) {
  for (int k = 0; k < frame.lights.caster_count(); ++k) {
    const Caster& caster = frame.lights.caster(k);
    Shadows& found = shades[k].of_all;
    switch (caster.rays) {
      case Rays::kPerspective: found = LookForShadows<Rays::kPerspective>(frame.solids, caster, tile, flat); break;
      case Rays::kParallel: found = LookForShadows<Rays::kParallel>(frame.solids, caster, tile, flat); break;
      case Rays::kAround: found = LookForShadows<Rays::kAround>(frame.solids, caster, tile, flat); break;
    }
  }
}

// Whether any light leaves the tile in part.
inline bool AnyInPart(const Lights& lights, const Shade* shades) {
  return std::any_of(shades, shades + lights.caster_count(),
                     [](const Shade& shade) { return shade.of_all == Shadows::kSome; });
}

void CastShadows(const Frame& frame, const Tile& tile, Shade* shades) {
  for (int k = 0; k < frame.lights.caster_count(); ++k) {
    if (shades[k].of_all != Shadows::kSome) continue;
    const Solids& solids = frame.solids;
    const Caster& caster = frame.lights.caster(k);
    const int behind = solids.meshes() ? 1 << k : 0;
    switch (caster.rays) {
      case Rays::kPerspective: CastShadows<Rays::kPerspective>(solids, caster, behind, tile, shades[k]); break;
      case Rays::kParallel: CastShadows<Rays::kParallel>(solids, caster, behind, tile, shades[k]); break;
      case Rays::kAround: CastShadows<Rays::kAround>(solids, caster, behind, tile, shades[k]); break;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
