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

#include "rays/intersect-inl.h"
#include "rays/lanes-inl.h"
#include "rays/lights.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// The points of a tile as a light sees them, and how far they are lit.
struct Shade {
  alignas(64) float u[kRays];
  float v[kRays];
  float w[kRays];  // depth; negative where there is nothing to light
  float lit[kRays];
  bool dark;  // whether anything may keep light from the tile; else nothing of the above is set
};

HWY_INLINE V LitAt(const Shade& shade, int i) { return shade.dark ? Load(shade.lit + i) : Set(1.0F); }

// How far a mesh is out of its own shadow, relative to its size.
constexpr float kMeshMargin = 1e-3F;

// Whether anything is still lit.
template <Form kKind, Rays kRaysKind>
HWY_NOINLINE bool ShadowAt(const Solid& solid, const Aspect& aspect, const Tile& tile, Shade& shade) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 a = Set(aspect.a);
  const V3 bx = Set(aspect.bx);
  const V3 by = Set(aspect.by);
  const V3 o = Set(aspect.o);
  const VI self = hn::Set(DI(), aspect.self);
  V any = Zero();
  for (int i = 0; i < kRays; i += lanes) {
    const V u = Load(shade.u + i);
    const V v = Load(shade.v + i);
    const V w = Load(shade.w + i);
    const V lit = Load(shade.lit + i);
    if (kRaysKind != Rays::kAround) {
      const M beside = hn::Or(hn::Or(hn::Lt(u, Set(aspect.left)), hn::Gt(u, Set(aspect.right))),
                              hn::Or(hn::Lt(v, Set(aspect.bottom)), hn::Gt(v, Set(aspect.top))));
      if (All(hn::Or(beside, hn::Lt(w, Set(aspect.nearest))))) {
        any = hn::Max(any, lit);
        continue;
      }
    }
    Ray ray;
    if (kRaysKind == Rays::kPerspective) {
      ray.o = o;
      ray.d = a + bx * u + by * v;
    } else if (kRaysKind == Rays::kParallel) {
      ray.o = a + bx * u + by * v;
      ray.d = o;
    } else {
      ray.o = o;
      ray.d = a * w + bx * u + by * v;
    }
    const V t = Enter<kKind>(solid, ray);
    const M own = hn::RebindMask(D(), hn::Eq(hn::Load(DI(), tile.id + i), self));
    // What is convex does not shade itself; a mesh may, where what is in the way is not the very point.
    V end = w;
    if (kRaysKind == Rays::kAround) end = Set(1.0F);
    if (kKind == Form::kMesh) {
      V margin = Set(kMeshMargin * solid.size[0]);
      if (kRaysKind == Rays::kAround) margin = margin * Rsqrt(hn::Max(Dot(ray.d, ray.d), Set(1e-20F)));
      end = end - hn::IfThenElseZero(own, margin);
    }
    M dark;
    if (kRaysKind == Rays::kParallel) {
      dark = hn::Lt(t, end - Set(1e-5F) * hn::Abs(end) - Set(1e-5F));
    } else {
      dark = hn::And(hn::Gt(t, Zero()), hn::Lt(t, end * Set(0.99998F)));
    }
    if (kKind != Form::kMesh) dark = hn::AndNot(own, dark);
    const V left = hn::IfThenZeroElse(dark, lit);
    any = hn::Max(any, left);
    Store(left, shade.lit + i);
  }
  return !All(hn::Eq(any, Zero()));
}

template <Rays kRaysKind>
bool Shadow(const Solid& solid, const Aspect& aspect, const Tile& tile, Shade& shade) {
  switch (solid.kind) {
    case Form::kPlane: return ShadowAt<Form::kPlane, kRaysKind>(solid, aspect, tile, shade);
    case Form::kSphere: return ShadowAt<Form::kSphere, kRaysKind>(solid, aspect, tile, shade);
    case Form::kCapsule: return ShadowAt<Form::kCapsule, kRaysKind>(solid, aspect, tile, shade);
    case Form::kEllipsoid: return ShadowAt<Form::kEllipsoid, kRaysKind>(solid, aspect, tile, shade);
    case Form::kCylinder: return ShadowAt<Form::kCylinder, kRaysKind>(solid, aspect, tile, shade);
    case Form::kBox: return ShadowAt<Form::kBox, kRaysKind>(solid, aspect, tile, shade);
    case Form::kMesh: return ShadowAt<Form::kMesh, kRaysKind>(solid, aspect, tile, shade);
  }
  return true;
}

// Bounds of points in a light's frame: of their slopes for a perspective light, else of their places.
struct Reach {
  float low[3], high[3];
};

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
      p[k] = light.o[k] +
             (light.a[k] + light.bx[k] * x[corner & 1] + light.by[k] * y[corner >> 1 & 1]) * t[corner >> 2 & 1];
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

// The tile's points in the light's frame, all of them lit, and their bounds; false if there are none. (Behind a
// spotlight nothing is lit.)
template <Rays kRaysKind>
bool PlacePoints(const Caster& light, const Tile& tile, Shade& shade, Reach& reach) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 a = Set(light.a);
  const V3 bx = Set(light.bx);
  const V3 o = Set(light.o);
  const V big = Set(kMiss);
  V3 low = {big, big, big};
  V3 high = low * Set(-1.0F);
  const V3 lowest = high;
  for (int row = 0; row < kTile; ++row) {
    const V3 base = a + Set(light.by) * Set(tile.y[row]);
    for (int column = 0; column < kTile; column += lanes) {
      const int i = row * kTile + column;
      V3 p = o + (base + bx * Load(tile.x + column)) * Load(tile.t + i);
      M valid = hn::RebindMask(D(), hn::Gt(hn::Load(DI(), tile.id + i), SetI(-1)));
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
  }
  const V lows[3] = {low.x, low.y, low.z};
  const V highs[3] = {high.x, high.y, high.z};
  for (int k = 0; k < 3; ++k) {
    reach.low[k] = hn::GetLane(hn::MinOfLanes(D(), lows[k]));
    reach.high[k] = hn::GetLane(hn::MaxOfLanes(D(), highs[k]));
  }
  return reach.low[0] <= reach.high[0];
}

template <Rays kRaysKind>
void CastShadows(const Solids& solids, const Caster& light, const Tile& tile, Shade& shade) {
  Reach reach;
  const Aspect* const first = light.aspects.data();
  const Aspect* const end = first + light.count;
  const auto shades = [&reach](const Aspect& aspect) { return MayShade<kRaysKind>(aspect, reach); };
  shade.dark = !BoundTile<kRaysKind>(light, tile, reach) || std::any_of(first, end, shades);
  if (!shade.dark || !PlacePoints<kRaysKind>(light, tile, shade, reach)) return;
  for (const Aspect* aspect = first; aspect < end; ++aspect) {
    if (shades(*aspect) && !Shadow<kRaysKind>(solids[aspect->solid], *aspect, tile, shade)) return;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
