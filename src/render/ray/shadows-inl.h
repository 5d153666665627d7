// Which points of a tile a light reaches.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RENDER_RAY_SHADOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RENDER_RAY_SHADOWS_INL_H
#undef MIMO_RENDER_RAY_SHADOWS_INL_H
#else
#define MIMO_RENDER_RAY_SHADOWS_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "render/ray/intersect-inl.h"
#include "render/ray/lanes-inl.h"
#include "render/ray/scene.h"
#include "render/ray/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::render::ray {
namespace HWY_NAMESPACE {

// The points of a tile as a light sees them, and how far they are lit.
struct Shade {
  alignas(64) float u[kRays];
  float v[kRays];
  float w[kRays];  // depth; negative where there is nothing to light
  float lit[kRays];
};

template <Kind kKind, Rays kRaysKind>
HWY_NOINLINE void ShadowAt(const Solid& solid, const Aspect& aspect, const Tile& tile, Shade& shade) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 a = Set(aspect.a);
  const V3 bx = Set(aspect.bx);
  const V3 by = Set(aspect.by);
  const V3 o = Set(aspect.o);
  const VI self = hn::Set(DI(), aspect.self);
  for (int i = 0; i < kRays; i += lanes) {
    const V u = Load(shade.u + i);
    const V v = Load(shade.v + i);
    const V w = Load(shade.w + i);
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
    M dark;
    if (kRaysKind == Rays::kPerspective) {
      dark = hn::And(hn::Gt(t, Zero()), hn::Lt(t, w * Set(0.99998F)));
    } else if (kRaysKind == Rays::kParallel) {
      dark = hn::Lt(t, w - Set(1e-5F) * hn::Abs(w) - Set(1e-5F));
    } else {
      dark = hn::And(hn::Gt(t, Zero()), hn::Lt(t, Set(0.99998F)));
    }
    dark = hn::And(dark, hn::RebindMask(D(), hn::Ne(hn::Load(DI(), tile.id + i), self)));
    Store(hn::IfThenZeroElse(dark, Load(shade.lit + i)), shade.lit + i);
  }
}

template <Rays kRaysKind>
void Shadow(const Solid& solid, const Aspect& aspect, const Tile& tile, Shade& shade) {
  switch (solid.kind) {
    case Kind::kPlane: ShadowAt<Kind::kPlane, kRaysKind>(solid, aspect, tile, shade); break;
    case Kind::kSphere: ShadowAt<Kind::kSphere, kRaysKind>(solid, aspect, tile, shade); break;
    case Kind::kCapsule: ShadowAt<Kind::kCapsule, kRaysKind>(solid, aspect, tile, shade); break;
    case Kind::kEllipsoid: ShadowAt<Kind::kEllipsoid, kRaysKind>(solid, aspect, tile, shade); break;
    case Kind::kCylinder: ShadowAt<Kind::kCylinder, kRaysKind>(solid, aspect, tile, shade); break;
    case Kind::kBox: ShadowAt<Kind::kBox, kRaysKind>(solid, aspect, tile, shade); break;
  }
}

template <Rays kRaysKind>
void CastShadows(const Scene& scene, const Eye& light, const Tile& tile, Shade& shade) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 a = Set(light.a);
  const V3 bx = Set(light.bx);
  const V3 o = Set(light.o);
  const V big = Set(kMiss);
  V u0 = big, v0 = big, w0 = big;
  V u1 = Zero() - big, v1 = u1, w1 = u1;
  for (int row = 0; row < kTile; ++row) {
    const V3 base = a + Set(light.by) * Set(tile.y[row]);
    for (int column = 0; column < kTile; column += lanes) {
      const int i = row * kTile + column;
      const V3 p = o + (base + bx * Load(tile.x + column)) * Load(tile.t + i);
      M valid = hn::RebindMask(D(), hn::Gt(hn::Load(DI(), tile.id + i), SetI(-1)));
      V u = p.x;
      V v = p.y;
      if (kRaysKind == Rays::kPerspective) {
        valid = hn::And(valid, hn::Gt(p.z, Zero()));
        const V over = Set(1.0F) / p.z;
        u = u * over;
        v = v * over;
      }
      Store(u, shade.u + i);
      Store(v, shade.v + i);
      Store(Pick(valid, p.z, Zero() - big), shade.w + i);
      Store(Set(1.0F), shade.lit + i);
      u0 = hn::Min(u0, Pick(valid, u, big));
      v0 = hn::Min(v0, Pick(valid, v, big));
      w0 = hn::Min(w0, Pick(valid, p.z, big));
      u1 = hn::Max(u1, Pick(valid, u, Zero() - big));
      v1 = hn::Max(v1, Pick(valid, v, Zero() - big));
      w1 = hn::Max(w1, Pick(valid, p.z, Zero() - big));
    }
  }
  const float left = hn::GetLane(hn::MinOfLanes(D(), u0));
  const float right = hn::GetLane(hn::MaxOfLanes(D(), u1));
  const float bottom = hn::GetLane(hn::MinOfLanes(D(), v0));
  const float top = hn::GetLane(hn::MaxOfLanes(D(), v1));
  const float deepest = hn::GetLane(hn::MaxOfLanes(D(), w1));
  if (left > right) return;
  // For rays around a point: a ball that holds the tile's points, and everything between it and the light.
  float center[3] = {0, 0, 0};
  float radius = 0;
  if (kRaysKind == Rays::kAround) {
    const float shallowest = hn::GetLane(hn::MinOfLanes(D(), w0));
    center[0] = 0.5F * (left + right);
    center[1] = 0.5F * (bottom + top);
    center[2] = 0.5F * (shallowest + deepest);
    radius = 0.5F * std::sqrt((right - left) * (right - left) + (top - bottom) * (top - bottom) +
                              (deepest - shallowest) * (deepest - shallowest));
  }
  for (int k = 0; k < light.count; ++k) {
    const Aspect& aspect = light.aspects[k];
    if (kRaysKind == Rays::kAround) {
      const auto& c = aspect.center;
      const float square = center[0] * center[0] + center[1] * center[1] + center[2] * center[2];
      const float along = square > 0 ? (c[0] * center[0] + c[1] * center[1] + c[2] * center[2]) / square : 0;
      const float s = std::min(std::max(along, 0.0F), 1.0F);
      float distance = 0;
      for (int j = 0; j < 3; ++j) distance += (c[j] - s * center[j]) * (c[j] - s * center[j]);
      const float reach = aspect.radius + radius;
      if (distance > reach * reach) continue;
    } else {
      if (aspect.nearest > deepest) break;
      if (aspect.left > right || aspect.right < left || aspect.bottom > top || aspect.top < bottom) continue;
    }
    Shadow<kRaysKind>(scene.solids[aspect.solid], aspect, tile, shade);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::render::ray
HWY_AFTER_NAMESPACE();

#endif
