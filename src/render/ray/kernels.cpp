// Compiled once for each instruction set: foreach_target includes this file again and again.
//
// Nothing here is fused or approximated by the hardware: sums, products, quotients and roots are IEEE's, so that all
// paths give the same picture, bit by bit.
#include "render/ray/kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#define HWY_IS_DEBUG_BUILD 0
// The vectors below are members of structs, which scalable vectors cannot be; of the x86 sets, these are enough.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/ray/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mimo::render::ray {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kTile>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using M = hn::Mask<D>;

constexpr int kRays = kTile * kTile;
constexpr float kMiss = 1e30F;

HWY_INLINE V Set(float v) { return hn::Set(D(), v); }
HWY_INLINE VI Whole(V v) { return hn::ConvertTo(DI(), v); }
HWY_INLINE V Real(VI v) { return hn::ConvertTo(D(), v); }
HWY_INLINE VI SetI(int v) { return hn::Set(DI(), v); }
HWY_INLINE V Zero() { return hn::Zero(D()); }
HWY_INLINE V Load(const float* p) { return hn::Load(D(), p); }
HWY_INLINE void Store(V v, float* p) { hn::Store(v, D(), p); }
HWY_INLINE V Pick(M m, V a, V b) { return hn::IfThenElse(m, a, b); }
HWY_INLINE bool None(M m) { return hn::AllFalse(D(), m); }
HWY_INLINE bool All(M m) { return hn::AllTrue(D(), m); }

struct V3 {
  V x, y, z;
};
HWY_INLINE V3 Set(const std::array<float, 3>& v) { return {Set(v[0]), Set(v[1]), Set(v[2])}; }
HWY_INLINE V Dot(const V3& a, const V3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE V3 operator-(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE V3 operator*(const V3& a, V k) { return {a.x * k, a.y * k, a.z * k}; }
HWY_INLINE V3 Pick(M m, const V3& a, const V3& b) { return {Pick(m, a.x, b.x), Pick(m, a.y, b.y), Pick(m, a.z, b.z)}; }

// ---------------------------------------------------------------------------------------------- where rays meet solids

struct Ray {
  V3 o, d;
};

// Where a ray enters a solid (kMiss where it does not), in the solid's frame. All solids are convex, and what is seen
// from inside is not drawn: the entry is all there is to know.
template <Kind kKind>
HWY_INLINE V Enter(const Solid& solid, const Ray& ray) {
  const V miss = Set(kMiss);
  V3 o = ray.o;
  V3 d = ray.d;
  if (kKind == Kind::kPlane) {
    const V t = (Zero() - o.z) / d.z;
    M hit = hn::Gt(t, Zero());
    if (solid.size[0] > 0) hit = hn::And(hit, hn::Le(hn::Abs(o.x + t * d.x), Set(solid.size[0])));
    if (solid.size[1] > 0) hit = hn::And(hit, hn::Le(hn::Abs(o.y + t * d.y), Set(solid.size[1])));
    return Pick(hit, t, miss);
  }
  if (kKind == Kind::kSphere || kKind == Kind::kEllipsoid) {
    V r2 = Set(solid.size[0] * solid.size[0]);
    if (kKind == Kind::kEllipsoid) {
      const V3 shrink = {Set(1 / solid.size[0]), Set(1 / solid.size[1]), Set(1 / solid.size[2])};
      o = {o.x * shrink.x, o.y * shrink.y, o.z * shrink.z};
      d = {d.x * shrink.x, d.y * shrink.y, d.z * shrink.z};
      r2 = Set(1.0F);
    }
    // The distance from the centre is |o x d| / |d|: this keeps its digits where o.o - r^2 would lose them.
    const V3 k = {o.y * d.z - o.z * d.y, o.z * d.x - o.x * d.z, o.x * d.y - o.y * d.x};
    const V a = Dot(d, d);
    const V h = r2 * a - Dot(k, k);
    const M hit = hn::Gt(h, Zero());
    if (None(hit)) return miss;
    return Pick(hit, (Zero() - Dot(o, d) - hn::Sqrt(hn::Max(h, Zero()))) / a, miss);
  }
  if (kKind == Kind::kCapsule) {
    const V r2 = Set(solid.size[0] * solid.size[0]);
    const V length = Set(solid.size[1]);
    const V k = o.x * d.y - o.y * d.x;
    const V a = hn::Max(d.x * d.x + d.y * d.y, Set(1e-30F));
    const V h = r2 * a - k * k;
    const M near_axis = hn::Gt(h, Zero());
    if (None(near_axis)) return miss;
    const V b = o.x * d.x + o.y * d.y;
    const V side = (Zero() - b - hn::Sqrt(hn::Max(h, Zero()))) / a;
    const V z = o.z + side * d.z;
    const M on_side = hn::Le(hn::Abs(z), length);
    V t = Pick(near_axis, side, miss);
    if (!All(hn::Or(on_side, hn::Not(near_axis)))) {
      const V oz = o.z - hn::CopySign(length, z);
      const V ka = o.y * d.z - oz * d.y;
      const V kb = oz * d.x - o.x * d.z;
      const V a3 = a + d.z * d.z;
      const V h3 = r2 * a3 - (ka * ka + kb * kb + k * k);
      const V end = (Zero() - (b + oz * d.z) - hn::Sqrt(hn::Max(h3, Zero()))) / a3;
      t = Pick(on_side, t, Pick(hn::And(near_axis, hn::Gt(h3, Zero())), end, miss));
    }
    return t;
  }
  if (kKind == Kind::kCylinder) {
    const V k = o.x * d.y - o.y * d.x;
    const V a = hn::Max(d.x * d.x + d.y * d.y, Set(1e-30F));
    const V h = Set(solid.size[0] * solid.size[0]) * a - k * k;
    const M near_axis = hn::Gt(h, Zero());
    if (None(near_axis)) return miss;
    const V b = o.x * d.x + o.y * d.y;
    const V root = hn::Sqrt(hn::Max(h, Zero()));
    const V over_a = Set(1.0F) / a;
    const V over_z = Set(1.0F) / d.z;
    const V length = Set(solid.size[1]);
    const V z0 = (Zero() - length - o.z) * over_z;
    const V z1 = (length - o.z) * over_z;
    const V in = hn::Max((Zero() - b - root) * over_a, hn::Min(z0, z1));
    const V out = hn::Min((root - b) * over_a, hn::Max(z0, z1));
    return Pick(hn::And(near_axis, hn::Lt(in, out)), in, miss);
  }
  // A box: the last entry into three slabs comes before the first exit.
  const V3 over = {Set(1.0F) / d.x, Set(1.0F) / d.y, Set(1.0F) / d.z};
  const V3 size = Set(solid.size);
  const V3 lo = {(Zero() - size.x - o.x) * over.x, (Zero() - size.y - o.y) * over.y, (Zero() - size.z - o.z) * over.z};
  const V3 hi = {(size.x - o.x) * over.x, (size.y - o.y) * over.y, (size.z - o.z) * over.z};
  const V in = hn::Max(hn::Max(hn::Min(lo.x, hi.x), hn::Min(lo.y, hi.y)), hn::Min(lo.z, hi.z));
  const V out = hn::Min(hn::Min(hn::Max(lo.x, hi.x), hn::Max(lo.y, hi.y)), hn::Max(lo.z, hi.z));
  return Pick(hn::Lt(in, out), in, miss);
}

// The rays of one tile and what they meet.
struct Tile {
  alignas(64) float x[kTile];  // slopes
  float y[kTile];
  float dx, dy;
  alignas(64) float t[kRays];          // depth of the nearest solid, kMiss for none
  alignas(64) std::int32_t id[kRays];  // its aspect, -1 for none
};

// The rows and columns of a tile that an aspect may touch; empty if first > last.
struct Window {
  int row0, row1, column0, column1;
};

constexpr Window kNothing = {0, -1, 0, -1};

HWY_INLINE bool IsEmpty(const Window& w) { return w.row0 > w.row1 || w.column0 > w.column1; }

HWY_INLINE int Clamped(float v) { return static_cast<int>(std::min(std::max(v, -1.0F), kTile + 1.0F)); }

HWY_INLINE Window WindowOf(const Aspect& aspect, const Tile& tile) {
  // The least of facing over the tile; rays beyond the last are close enough.
  const float far_x = tile.x[0] + tile.dx * kTile;
  const float far_y = tile.y[0] + tile.dy * kTile;
  const float least = aspect.facing[0] + std::min(aspect.facing[1] * tile.x[0], aspect.facing[1] * far_x) +
                      std::min(aspect.facing[2] * tile.y[0], aspect.facing[2] * far_y);
  if (least > 0) return kNothing;
  const float over_x = 1 / tile.dx;
  const float over_y = 1 / tile.dy;  // negative: rows go down
  Window w;
  w.column0 = std::max(Clamped((aspect.left - tile.x[0]) * over_x), 0);
  w.column1 = std::min(Clamped((aspect.right - tile.x[0]) * over_x + 1), kTile) - 1;
  w.row0 = std::max(Clamped((aspect.top - tile.y[0]) * over_y), 0);
  w.row1 = std::min(Clamped((aspect.bottom - tile.y[0]) * over_y + 1), kTile) - 1;
  return w;
}

// Casts the tile's rays at one solid. `from` is the depth from which on it is seen: for all rays, or for each.
template <Kind kKind, bool kFromEach>
HWY_NOINLINE void CastAt(const Solid& solid, const Aspect& aspect, int index, const Tile& tile, const Window& w,
                         const float* from, float* HWY_RESTRICT best, std::int32_t* HWY_RESTRICT id) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const int first = w.column0 / lanes * lanes;
  const V3 bx = Set(aspect.bx);
  const VI index_v = hn::Set(DI(), index);
  Ray ray;
  ray.o = Set(aspect.o);
  for (int row = w.row0; row <= w.row1; ++row) {
    const float y = tile.y[row];
    const V3 base = {Set(aspect.a[0] + y * aspect.by[0]), Set(aspect.a[1] + y * aspect.by[1]),
                     Set(aspect.a[2] + y * aspect.by[2])};
    for (int column = first; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      ray.d = base + bx * Load(tile.x + column);
      const V t = Enter<kKind>(solid, ray);
      const V old = Load(best + i);
      const M seen = hn::And(hn::Lt(t, old), hn::Ge(t, kFromEach ? Load(from + i) : Set(*from)));
      if (None(seen)) continue;
      Store(Pick(seen, t, old), best + i);
      const VI old_id = hn::Load(DI(), id + i);
      hn::Store(hn::IfThenElse(hn::RebindMask(DI(), seen), index_v, old_id), DI(), id + i);
    }
  }
}

template <bool kFromEach>
void Cast(const Scene& scene, const Eye& eye, int index, const Tile& tile, const Window& w, const float* from,
          float* best, std::int32_t* id) {
  const Aspect& aspect = eye.aspects[index];
  const Solid& solid = scene.solids[aspect.solid];
  switch (solid.kind) {
    case Kind::kPlane: CastAt<Kind::kPlane, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Kind::kSphere: CastAt<Kind::kSphere, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Kind::kCapsule: CastAt<Kind::kCapsule, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Kind::kEllipsoid: CastAt<Kind::kEllipsoid, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Kind::kCylinder: CastAt<Kind::kCylinder, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Kind::kBox: CastAt<Kind::kBox, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
  }
}

// ----------------------------------------------------------------------------------------------------------- shadows

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

// ---------------------------------------------------------------------------------------------------------- textures

// Colours with their channels in the 16-bit halves of two vectors.
struct Texel {
  VI rb, g;
};

// a + (b - a) weight, with the weight in 1/32768 in both halves.
HWY_INLINE VI Mix(VI a, VI b, VI weight) {
#if HWY_TARGET == HWY_SCALAR
  const auto half = [weight](std::int32_t from, std::int32_t to) {
    const std::int32_t w = weight.raw & 0xFFFF;
    return from + (((to - from) * w + 0x4000) >> 15);
  };
  const std::int32_t low = half(a.raw & 0xFFFF, b.raw & 0xFFFF);
  const std::int32_t high = half(a.raw >> 16, b.raw >> 16);
  return SetI(low | high << 16);
#else
  const hn::Repartition<std::int16_t, D> half;
  const auto from = hn::BitCast(half, a);
  const auto step = hn::MulFixedPoint15(hn::Sub(hn::BitCast(half, b), from), hn::BitCast(half, weight));
  return hn::BitCast(DI(), hn::Add(from, step));
#endif
}

HWY_INLINE Texel Mix(const Texel& a, const Texel& b, VI w) { return {Mix(a.rb, b.rb, w), Mix(a.g, b.g, w)}; }

// The weight of a fraction 0..1.
HWY_INLINE VI Weight(V fraction) {
  const VI w = Whole(fraction * Set(32767.0F));
  return hn::Or(w, hn::ShiftLeft<16>(w));
}

HWY_INLINE Texel Unpack(VI texel) {
  const VI mask = SetI(0x00FF00FF);
  return {hn::And(texel, mask), hn::And(hn::ShiftRight<8>(texel), SetI(0x000000FF))};
}

// Texels at `index` and their neighbours to the right, mixed.
HWY_INLINE Texel FetchRow(const std::uint32_t* texels, VI index, VI weight) {
#if HWY_TARGET == HWY_SCALAR
  const std::int32_t* at = reinterpret_cast<const std::int32_t*>(texels) + index.raw;
  return Mix(Unpack(SetI(at[0])), Unpack(SetI(at[1])), weight);
#else
  const hn::Repartition<std::int64_t, D> pair;
  const auto* base = reinterpret_cast<const std::int64_t*>(texels);
  const auto low = hn::GatherOffset(pair, base, hn::ShiftLeft<2>(hn::PromoteTo(pair, hn::LowerHalf(index))));
  const auto high = hn::GatherOffset(
      pair, base, hn::ShiftLeft<2>(hn::PromoteTo(pair, hn::UpperHalf(hn::Half<DI>(), index))));
  const VI a = hn::BitCast(DI(), low);
  const VI b = hn::BitCast(DI(), high);
  return Mix(Unpack(hn::ConcatEven(DI(), b, a)), Unpack(hn::ConcatOdd(DI(), b, a)), weight);
#endif
}

// One level, between four texels, with s and t in 0..1.
HWY_INLINE Texel Bilinear(const std::uint32_t* texels, VI origin, VI stride, V width, V height, V s, V t) {
  // The limits only matter to rays whose result is not used: they must not fetch from nowhere.
  const V u = hn::Min(hn::Max(s * width - Set(0.5F), Set(-1.0F)), width - Set(0.5F));
  const V v = hn::Min(hn::Max(t * height - Set(0.5F), Set(-1.0F)), height - Set(0.5F));
  const V u0 = hn::Floor(u);
  const V v0 = hn::Floor(v);
  const VI index = hn::Add(hn::Add(origin, Whole(u0)), hn::Mul(Whole(v0), stride));
  const VI weight = Weight(u - u0);
  const Texel upper = FetchRow(texels, index, weight);
  const Texel lower = FetchRow(texels, hn::Add(index, stride), weight);
  return Mix(upper, lower, Weight(v - v0));
}

// log2 of a positive number, to 1e-4.
HWY_INLINE V Log2(V x) {
  const VI bits = hn::BitCast(DI(), x);
  const V exponent = Real(hn::Sub(hn::ShiftRight<23>(bits), SetI(127)));
  const V m = hn::BitCast(D(), hn::Or(hn::And(bits, SetI(0x007FFFFF)), SetI(0x3F800000)));  // 1..2
  // ln(m) = 2 atanh(z) with z = (m - 1) / (m + 1) in 0..1/3.
  const V z = (m - Set(1.0F)) / (m + Set(1.0F));
  const V z2 = z * z;
  const V series = ((z2 * Set(0.41219858F) + Set(0.57707802F)) * z2 + Set(0.96179669F)) * z2 + Set(2.88539008F);
  return exponent + z * series;
}

// 1 / sqrt(x) to 5e-6, which is plenty for colours, at a third of the cost of the exact one, and the same everywhere.
HWY_INLINE V Rsqrt(V x) {
  V y = hn::BitCast(D(), hn::Sub(SetI(0x5F375A86), hn::ShiftRight<1>(hn::BitCast(DI(), x))));
  const V half = x * Set(0.5F);
  y = y * (Set(1.5F) - half * y * y);
  return y * (Set(1.5F) - half * y * y);
}

// 2^x for x in -126..126.
HWY_INLINE V Exp2(V x) {
  const V whole = hn::Floor(x);
  const V f = x - whole;
  const V p = ((((f * Set(0.0018775767F) + Set(0.0089893397F)) * f + Set(0.055826318F)) * f + Set(0.24015361F)) * f +
               Set(0.69315308F)) * f + Set(0.99999994F);
  const VI scale = hn::ShiftLeft<23>(hn::Add(Whole(whole), SetI(127)));
  return p * hn::BitCast(D(), scale);
}

HWY_INLINE V Pow(const Power& power, V x) {
  if (power.whole >= 0) {
    V result = power.whole & 1 ? x : Set(1.0F);
    for (int n = power.whole >> 1; n > 0; n >>= 1) {
      x = x * x;
      if (n & 1) result = result * x;
    }
    return result;
  }
  return Exp2(hn::Max(Log2(hn::Max(x, Set(1e-30F))) * Set(power.exponent), Set(-100.0F)));
}

// Where a level begins, and its size.
struct Place {
  VI origin, stride;
  V width, height;
};

template <bool kCube>
HWY_INLINE Place PlaceOf(const Texture& texture, int level, VI face) {
  const int width = std::max(texture.width >> level, 1);
  const int height = std::max(texture.height >> level, 1);
  VI origin = SetI(texture.origin[level]);
  if (kCube) origin = hn::Add(origin, hn::Mul(face, SetI((width + 2) * (height + 2))));
  return {origin, SetI(width + 2), Set(static_cast<float>(width)), Set(static_cast<float>(height))};
}

template <bool kCube>
HWY_NOINLINE Place PlaceOf(const Texture& texture, VI level, VI face) {
  const VI one = SetI(1);
  const VI two = SetI(2);
  const VI width = hn::Max(hn::Shr(SetI(texture.width), level), one);
  const VI height = hn::Max(hn::Shr(SetI(texture.height), level), one);
  VI origin = hn::GatherIndex(DI(), texture.origin.data(), level);
  if (kCube) origin = hn::Add(origin, hn::Mul(face, hn::Mul(hn::Add(width, two), hn::Add(height, two))));
  return {origin, hn::Add(width, two), Real(width), Real(height)};
}

// Colour 0..1 of a texture at s, t (of a cube's face), with `spread` the square of the texels that a pixel spans.
template <bool kCube>
HWY_INLINE V3 Sample(const std::uint32_t* texels, const Texture& texture, VI face, V s, V t, V spread) {
  if (!kCube) {
    s = s - hn::Floor(s);
    t = t - hn::Floor(t);
  }
  Texel texel;
  if (texture.levels == 1 || All(hn::Le(spread, Set(1.0F)))) {
    const Place p = PlaceOf<kCube>(texture, 0, face);
    texel = Bilinear(texels, p.origin, p.stride, p.width, p.height, s, t);
  } else {
    const V level = hn::Min(Set(0.5F) * Log2(hn::Min(hn::Max(spread, Set(1.0F)), Set(1e12F))),
                            Set(static_cast<float>(texture.levels - 1)));
    const V below = hn::Floor(level);
    const VI l0 = Whole(below);
    const VI l1 = hn::Min(hn::Add(l0, SetI(1)), SetI(texture.levels - 1));
    const int first = hn::GetLane(l0);
    Place p;
    Place q;
    if (hn::AllTrue(DI(), hn::Eq(l0, SetI(first)))) {
      p = PlaceOf<kCube>(texture, first, face);
      q = PlaceOf<kCube>(texture, std::min(first + 1, texture.levels - 1), face);
    } else {
      p = PlaceOf<kCube>(texture, l0, face);
      q = PlaceOf<kCube>(texture, l1, face);
    }
    texel = Mix(Bilinear(texels, p.origin, p.stride, p.width, p.height, s, t),
                Bilinear(texels, q.origin, q.stride, q.width, q.height, s, t), Weight(level - below));
  }
  const VI byte = SetI(255);
  const V k = Set(1.0F / 255);
  return {Real(hn::And(texel.rb, byte)) * k, Real(texel.g) * k, Real(hn::ShiftRight<16>(texel.rb)) * k};
}

// A cube texture in direction q; gx and gy are how q changes from pixel to pixel.
HWY_INLINE V3 SampleCube(const std::uint32_t* texels, const Texture& texture, const V3& q, const V3& gx,
                         const V3& gy) {
  const V ax = hn::Abs(q.x);
  const V ay = hn::Abs(q.y);
  const V az = hn::Abs(q.z);
  const M on_x = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az));
  const M on_y = hn::AndNot(on_x, hn::Ge(ay, az));
  const V major = Pick(on_x, q.x, Pick(on_y, q.y, q.z));
  const M negative = hn::Lt(major, Zero());
  const V minus_z = Zero() - q.z;
  const V sc = Pick(on_x, Pick(negative, q.z, minus_z),
                    Pick(on_y, q.x, Pick(negative, Zero() - q.x, q.x)));
  const V tc = Pick(on_y, Pick(negative, minus_z, q.z), Zero() - q.y);
  const V half = Set(0.5F) / hn::Max(hn::Abs(major), Set(1e-30F));
  VI face = hn::IfThenElse(hn::RebindMask(DI(), on_x), hn::Zero(DI()),
                           hn::IfThenElse(hn::RebindMask(DI(), on_y), SetI(2), SetI(4)));
  face = hn::Add(face, hn::IfThenElse(hn::RebindMask(DI(), negative), SetI(1), hn::Zero(DI())));
  const V texels_each = half * Set(static_cast<float>(texture.width));
  const V spread = hn::Max(Dot(gx, gx), Dot(gy, gy)) * (texels_each * texels_each);
  return Sample<true>(texels, texture, face, sc * half + Set(0.5F), tc * half + Set(0.5F), spread);
}

// ---------------------------------------------------------------------------------------------------------- lighting

// The part of v along the normal n.
template <Kind kKind>
HWY_INLINE V Along(const V3& n, const V3& v) {
  return kKind == Kind::kPlane ? v.z : Dot(n, v);
}

// The colours of a tile's rays.
struct Canvas {
  alignas(64) float r[kRays];
  float g[kRays];
  float b[kRays];
};

enum class Brush { kPut, kAdd, kBlend };

// What is painted: the rays of a tile that met the solid which aspect `index` shows.
struct Subject {
  const Scene* scene;
  const Eye* eye;
  int index;
  const Tile* tile;
  const float* t;
  const std::int32_t* id;
  const Shade* shades;  // one a caster; null where no shadows are wanted
  float dim;            // what the colour is multiplied by
};

// The normal of a solid at a point of its surface, in its frame.
template <Kind kKind>
HWY_INLINE V3 Normal(const Solid& solid, const V3& p) {
  const V one = Set(1.0F);
  switch (kKind) {
    case Kind::kPlane: return {Zero(), Zero(), one};
    case Kind::kSphere: return p * Set(1 / solid.size[0]);
    case Kind::kCapsule: {
      const V length = Set(solid.size[1]);
      const V z = hn::Min(hn::Max(p.z, Zero() - length), length);
      return V3{p.x, p.y, p.z - z} * Set(1 / solid.size[0]);
    }
    case Kind::kEllipsoid: {
      const V3 n = {p.x * Set(1 / (solid.size[0] * solid.size[0])), p.y * Set(1 / (solid.size[1] * solid.size[1])),
                    p.z * Set(1 / (solid.size[2] * solid.size[2]))};
      return n * Rsqrt(Dot(n, n));
    }
    case Kind::kCylinder: {
      // How far p lies beyond the end, against how far beyond the side.
      const V beyond = hn::Abs(p.z) - Set(solid.size[1]);
      const V aside = (p.x * p.x + p.y * p.y) * Set(0.5F / solid.size[0]) - Set(0.5F * solid.size[0]);
      const V over = Set(1 / solid.size[0]);
      return Pick(hn::Gt(beyond, aside), {Zero(), Zero(), hn::CopySign(one, p.z)}, {p.x * over, p.y * over, Zero()});
    }
    default: {
      const V3 beyond = {hn::Abs(p.x) - Set(solid.size[0]), hn::Abs(p.y) - Set(solid.size[1]),
                         hn::Abs(p.z) - Set(solid.size[2])};
      const M on_x = hn::And(hn::Ge(beyond.x, beyond.y), hn::Ge(beyond.x, beyond.z));
      const M on_y = hn::AndNot(on_x, hn::Ge(beyond.y, beyond.z));
      const M on_z = hn::Not(hn::Or(on_x, on_y));
      return {hn::IfThenElseZero(on_x, hn::CopySign(one, p.x)), hn::IfThenElseZero(on_y, hn::CopySign(one, p.y)),
              hn::IfThenElseZero(on_z, hn::CopySign(one, p.z))};
    }
  }
}

// The light that falls on a solid, scattered and mirrored towards the eye: its colour without the texture. A light
// with shadows is added after what all others give is cut at white, and cut by itself, as OpenGL does, which draws
// it in a pass of its own.
template <Kind kKind, bool kGray>
HWY_INLINE V3 Lit(const Subject& subject, const Aspect& aspect, const V3& ray, const V3& p, const V3& n, int i) {
  const Scene& scene = *subject.scene;
  const Material& material = scene.solids[aspect.solid].material;
  const V one = Set(1.0F);
  const bool shiny = material.specular > 0;
  V3 to_eye = ray;
  if (shiny) to_eye = ray * (Zero() - Rsqrt(Dot(ray, ray)));

  const V dim = Set(subject.dim);
  const V3 rgb = Set(material.rgb) * dim;
  // Light that falls in: what the colour scatters and what it mirrors (y and z only where light is coloured).
  V3 diffuse = {Set(scene.ambient), Set(scene.ambient), Set(scene.ambient)};
  V3 mirrored = {Zero(), Zero(), Zero()};
  V3 extra = {Zero(), Zero(), Zero()};  // of lights with shadows
  for (int k = 0; k < scene.light_count; ++k) {
    const Light& light = scene.lights[k];
    const LocalLight& place = scene.local[static_cast<std::size_t>(aspect.solid) * kMaxLights + k];
    const bool separate = subject.shades != nullptr && light.caster >= 0;
    V lit = one;
    if (separate) {
      lit = Load(subject.shades[light.caster].lit + i);
      if (All(hn::Eq(lit, Zero()))) continue;
    }
    V3 to_light = Set(place.position);
    V strength = one;
    if (!light.directional) {
      to_light = to_light - p;
      const V square = Dot(to_light, to_light);
      const V over = Rsqrt(square);
      to_light = to_light * over;
      if (light.attenuated) {
        const V length = square * over;
        strength = one / (Set(light.attenuation[0]) + Set(light.attenuation[1]) * length +
                          Set(light.attenuation[2]) * square);
      }
      if (light.spot) {
        const V cosine = Zero() - Dot(to_light, Set(place.direction));
        const M inside = hn::Ge(cosine, Set(light.cos_cutoff));
        if (None(inside)) continue;
        strength = hn::IfThenElseZero(inside, strength * Pow(light.exponent, hn::Max(cosine, Zero())));
      }
    }
    const V facing = hn::Max(Along<kKind>(n, to_light), Zero());
    V glint = Zero();
    if (shiny && light.bright) {
      const V3 half = to_light + to_eye;
      const V cosine = hn::Max(Along<kKind>(n, half), Zero()) * Rsqrt(Dot(half, half));
      glint = hn::IfThenElseZero(hn::Gt(facing, Zero()), Pow(material.shininess, hn::Min(cosine, one)));
      glint = glint * Set(material.specular);
    }
    // It does not reach faces that look away from it either, not even with its ambient part.
    if (separate) {
      const V on = hn::IfThenElseZero(hn::Gt(facing, Zero()), lit);
      if (kGray) {
        const V d = strength * (Set(light.ambient[0]) + facing * Set(light.diffuse[0]));
        const V s = strength * glint * Set(light.specular[0]);
        extra.x = extra.x + on * hn::Min(rgb.x * d + s, one);
        extra.y = extra.y + on * hn::Min(rgb.y * d + s, one);
        extra.z = extra.z + on * hn::Min(rgb.z * d + s, one);
      } else {
        const V3 d = (Set(light.ambient) + Set(light.diffuse) * facing) * strength;
        const V3 s = Set(light.specular) * (glint * strength);
        extra.x = extra.x + on * hn::Min(rgb.x * d.x + s.x, one);
        extra.y = extra.y + on * hn::Min(rgb.y * d.y + s.y, one);
        extra.z = extra.z + on * hn::Min(rgb.z * d.z + s.z, one);
      }
    } else if (kGray) {
      diffuse.x = diffuse.x + strength * (Set(light.ambient[0]) + facing * Set(light.diffuse[0]));
      mirrored.x = mirrored.x + strength * glint * Set(light.specular[0]);
    } else {
      diffuse = diffuse + (Set(light.ambient) + Set(light.diffuse) * facing) * strength;
      mirrored = mirrored + Set(light.specular) * (glint * strength);
    }
  }
  V3 color;
  if (kGray) {
    color = rgb * diffuse.x + V3{mirrored.x, mirrored.x, mirrored.x};
  } else {
    color = {rgb.x * diffuse.x + mirrored.x, rgb.y * diffuse.y + mirrored.y, rgb.z * diffuse.z + mirrored.z};
  }
  color = color + Set(material.emission) * dim;
  return {hn::Min(color.x, one) + extra.x, hn::Min(color.y, one) + extra.y, hn::Min(color.z, one) + extra.z};
}

// The colour of a solid's texture.
template <Kind kKind>
HWY_INLINE V3 Textured(const Subject& subject, const Aspect& aspect, const V3& ray, const V3& p, const V3& n, V t) {
  const Scene& scene = *subject.scene;
  const Material& material = scene.solids[aspect.solid].material;
  const Texture& texture = *material.texture;
  const V3 bx = Set(aspect.bx);
  const V3 by = Set(aspect.by);
  // How the point moves on its tangent plane from pixel to pixel.
  // (Of a plane, t says how far away it is across.)
  const V over = kKind == Kind::kPlane ? t * Set(-1 / aspect.o[2]) : Set(1.0F) / Along<kKind>(n, ray);
  const V3 along_x = (bx - ray * (Along<kKind>(n, bx) * over)) * (t * Set(subject.tile->dx));
  const V3 along_y = (by - ray * (Along<kKind>(n, by) * over)) * (t * Set(subject.tile->dy));
  if (material.mapping == Mapping::kFlat) {
    const V wide = Set(material.scale[0] * static_cast<float>(texture.width));
    const V high = Set(material.scale[1] * static_cast<float>(texture.height));
    const V spread_x = (along_x.x * wide) * (along_x.x * wide) + (along_x.y * high) * (along_x.y * high);
    const V spread_y = (along_y.x * wide) * (along_y.x * wide) + (along_y.y * high) * (along_y.y * high);
    return Sample<false>(scene.texels, texture, hn::Zero(DI()), p.x * Set(material.scale[0]) - Set(0.5F),
                         p.y * Set(material.scale[1]) - Set(0.5F), hn::Max(spread_x, spread_y));
  }
  const V fold = Set(material.fold);
  const V z = hn::Min(hn::Max(p.z, Zero() - fold), fold);
  const V3 scale = {Set(material.scale[0]), Set(material.scale[1]), Set(material.scale[2])};
  const V3 q = {p.x * scale.x, p.y * scale.y, z * scale.z + (p.z - z) * Set(material.scale[3])};
  const V3 gx = {along_x.x * scale.x, along_x.y * scale.y, along_x.z * scale.z};
  const V3 gy = {along_y.x * scale.x, along_y.y * scale.y, along_y.z * scale.z};
  return SampleCube(scene.texels, texture, q, gx, gy);
}

template <Kind kKind, bool kGray, Brush kBrush>
HWY_NOINLINE void PaintKind(const Subject& subject, const Window& w, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const Aspect& aspect = subject.eye->aspects[subject.index];
  const Solid& solid = subject.scene->solids[aspect.solid];
  const V one = Set(1.0F);
  for (int row = w.row0; row <= w.row1; ++row) {
    for (int column = w.column0 / lanes * lanes; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      const M mine = hn::RebindMask(D(), hn::Eq(hn::Load(DI(), subject.id + i), SetI(subject.index)));
      if (None(mine)) continue;
      const V t = Load(subject.t + i);
      const V3 ray =
          Set(aspect.a) + Set(aspect.by) * Set(subject.tile->y[row]) + Set(aspect.bx) * Load(subject.tile->x + column);
      const V3 p = Set(aspect.o) + ray * t;
      const V3 n = Normal<kKind>(solid, p);
      V3 color = Lit<kKind, kGray>(subject, aspect, ray, p, n, i);
      if (solid.material.mapping != Mapping::kNone) {
        const V3 texel = Textured<kKind>(subject, aspect, ray, p, n, t);
        color = {color.x * texel.x, color.y * texel.y, color.z * texel.z};
      }
      color = {hn::Min(color.x, one), hn::Min(color.y, one), hn::Min(color.z, one)};
      V3 old = {Load(canvas.r + i), Load(canvas.g + i), Load(canvas.b + i)};
      if (kBrush == Brush::kAdd) color = color + old;
      if (kBrush == Brush::kBlend) {
        const V alpha = Set(solid.material.alpha);
        color = old * (one - alpha) + color * alpha;
      }
      Store(Pick(mine, color.x, old.x), canvas.r + i);
      Store(Pick(mine, color.y, old.y), canvas.g + i);
      Store(Pick(mine, color.z, old.z), canvas.b + i);
    }
  }
}

template <Kind kKind, Brush kBrush>
HWY_INLINE void PaintGrayOrNot(const Subject& subject, const Window& w, Canvas& canvas) {
  if (subject.scene->gray) {
    PaintKind<kKind, true, kBrush>(subject, w, canvas);
  } else {
    PaintKind<kKind, false, kBrush>(subject, w, canvas);
  }
}

template <Brush kBrush>
void Paint(const Subject& subject, const Window& w, Canvas& canvas) {
  switch (subject.scene->solids[subject.eye->aspects[subject.index].solid].kind) {
    case Kind::kPlane: PaintGrayOrNot<Kind::kPlane, kBrush>(subject, w, canvas); break;
    case Kind::kSphere: PaintGrayOrNot<Kind::kSphere, kBrush>(subject, w, canvas); break;
    case Kind::kCapsule: PaintGrayOrNot<Kind::kCapsule, kBrush>(subject, w, canvas); break;
    case Kind::kEllipsoid: PaintGrayOrNot<Kind::kEllipsoid, kBrush>(subject, w, canvas); break;
    case Kind::kCylinder: PaintGrayOrNot<Kind::kCylinder, kBrush>(subject, w, canvas); break;
    case Kind::kBox: PaintGrayOrNot<Kind::kBox, kBrush>(subject, w, canvas); break;
  }
}

// -------------------------------------------------------------------------------------------------- sky, haze and fog

void PaintSky(const Scene& scene, const Tile& tile, const std::int32_t* id, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 bx = Set(scene.sky_bx);
  const V3 by = Set(scene.sky_by);
  const V3 gx = bx * Set(tile.dx);
  const V3 gy = by * Set(tile.dy);
  for (int i = 0; i < kRays; i += lanes) {
    const M empty = hn::RebindMask(D(), hn::Lt(hn::Load(DI(), id + i), hn::Zero(DI())));
    if (None(empty)) continue;
    const V3 d = Set(scene.sky_a) + by * Set(tile.y[i / kTile]) + bx * Load(tile.x + i % kTile);
    const V3 color = SampleCube(scene.texels, *scene.sky, d, gx, gy);
    Store(Pick(empty, color.x, Load(canvas.r + i)), canvas.r + i);
    Store(Pick(empty, color.y, Load(canvas.g + i)), canvas.g + i);
    Store(Pick(empty, color.z, Load(canvas.b + i)), canvas.b + i);
  }
}

// The haze is a cone that rises from the ground at distance (1 - r) of the sky's to the height of the eye at the sky;
// its density grows linearly up to `turn` and falls again.
void PaintHaze(const Scene& scene, const Tile& tile, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 a = Set(scene.haze_a);
  const V3 bx = Set(scene.haze_bx);
  const V3 by = Set(scene.haze_by);
  const V one = Set(1.0F);
  const V e = Set(scene.haze_elevation / scene.haze_radius);
  const V turn = Set(scene.haze_turn);
  for (int i = 0; i < kRays; i += lanes) {
    const V t = Load(tile.t + i);
    if (All(hn::Lt(t, Set(0.3F * scene.sky_limit)))) continue;
    const V3 ray = a + by * Set(tile.y[i / kTile]) + bx * Load(tile.x + i % kTile);
    const M down = hn::Lt(ray.z, Zero());
    if (None(down)) continue;
    const V level = hn::Sqrt(ray.x * ray.x + ray.y * ray.y);
    const V drop = (Zero() - ray.z) / hn::Max(level, Set(1e-20F));
    const V distance = e / hn::Max(e + drop, Set(1e-20F));
    const V height = one - (one - distance) * Set(1 / scene.haze_radius);
    V alpha = hn::Min(height / turn, (one - height) / (one - turn));
    const M here = hn::And(hn::And(down, hn::Gt(alpha, Zero())),
                           hn::Gt(t * level, distance * Set(scene.sky_limit)));
    if (None(here)) continue;
    alpha = hn::IfThenElseZero(here, hn::Min(alpha, one));
    const V rest = one - alpha;
    Store(Load(canvas.r + i) * rest + Set(scene.haze_rgb[0]) * alpha, canvas.r + i);
    Store(Load(canvas.g + i) * rest + Set(scene.haze_rgb[1]) * alpha, canvas.g + i);
    Store(Load(canvas.b + i) * rest + Set(scene.haze_rgb[2]) * alpha, canvas.b + i);
  }
}

void PaintFog(const Scene& scene, const Tile& tile, const std::int32_t* id, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V one = Set(1.0F);
  for (int i = 0; i < kRays; i += lanes) {
    const M solid = hn::RebindMask(D(), hn::Gt(hn::Load(DI(), id + i), SetI(-1)));
    const V part = (Load(tile.t + i) - Set(scene.fog_start)) * Set(scene.fog_scale);
    const V f = hn::IfThenElseZero(solid, hn::Min(hn::Max(part, Zero()), one));
    Store(Load(canvas.r + i) * (one - f) + Set(scene.fog_rgb[0]) * f, canvas.r + i);
    Store(Load(canvas.g + i) * (one - f) + Set(scene.fog_rgb[1]) * f, canvas.g + i);
    Store(Load(canvas.b + i) * (one - f) + Set(scene.fog_rgb[2]) * f, canvas.b + i);
  }
}

// ------------------------------------------------------------------------------------------------------------ tiles

HWY_INLINE std::uint32_t Average(const std::uint32_t* color, int samples) {
  std::uint32_t sum[3] = {0, 0, 0};
  for (int row = 0; row < samples; ++row) {
    for (int column = 0; column < samples; ++column) {
      const std::uint32_t c = color[row * kTile + column];
      for (int k = 0; k < 3; ++k) sum[k] += (c >> (8 * k)) & 255U;
    }
  }
  const std::uint32_t count = static_cast<std::uint32_t>(samples * samples);
  std::uint32_t mean = 0;
  for (int k = 0; k < 3; ++k) mean |= ((sum[k] + count / 2) / count) << (8 * k);
  return mean;
}

void WriteColor(const Job& job, int tile_row, int tile_column, const std::uint32_t* color) {
  const int n = job.samples;
  const int size = kTile / n;
  const int width = std::min(size, job.width - tile_column * size);
  const int height = std::min(size, job.height - tile_row * size);
  for (int row = 0; row < height; ++row) {
    std::uint8_t* to = job.rgb + 3 * (static_cast<std::size_t>(tile_row * size + row) * job.width + tile_column * size);
    const std::uint32_t* from = color + row * n * kTile;
    if (n == 1) {
      // Four bytes at a time where the fourth is overwritten by the next pixel anyway.
      for (int column = 0; column + 1 < width; ++column) std::memcpy(to + 3 * column, from + column, 4);
      std::memcpy(to + 3 * (width - 1), from + width - 1, 3);
    } else {
      for (int column = 0; column < width; ++column) {
        const std::uint32_t mean = Average(from + column * n, n);
        std::memcpy(to + 3 * column, &mean, 3);
      }
    }
  }
}

// The mirror's reflections, where the tile shows the mirror.
void PaintMirror(const Scene& scene, const Tile& tile, const std::int32_t* shown, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const int mirror = scene.seen[scene.mirror];
  if (mirror < 0) return;
  const Window all = WindowOf(scene.camera.aspects[mirror], tile);
  if (IsEmpty(all)) return;
  alignas(64) float t[kRays];
  alignas(64) std::int32_t id[kRays];
  bool any = false;
  for (int k = 0; k < scene.mirrored.count; ++k) {
    const Window w = WindowOf(scene.mirrored.aspects[k], tile);
    if (IsEmpty(w)) continue;
    if (!any) {
      any = true;
      std::fill_n(t, kRays, kMiss);
      std::fill_n(id, kRays, -1);
    }
    Cast<true>(scene, scene.mirrored, k, tile, w, tile.t, t, id);
  }
  if (!any) return;
  // Of a box, only the upper face mirrors.
  const Solid& solid = scene.solids[scene.mirror];
  const Aspect& aspect = scene.camera.aspects[mirror];
  const V upper = Set(solid.kind == Kind::kBox ? solid.size[2] * 0.9999F : -kMiss);
  for (int i = 0; i < kRays; i += lanes) {
    const V z = Set(aspect.o[2]) + Load(tile.t + i) * (Set(aspect.a[2]) + Set(aspect.by[2]) * Set(tile.y[i / kTile]) +
                                                       Set(aspect.bx[2]) * Load(tile.x + i % kTile));
    M reflects = hn::RebindMask(D(), hn::Eq(hn::Load(DI(), shown + i), SetI(mirror)));
    reflects = hn::And(reflects, hn::Gt(z, upper));
    hn::Store(hn::IfThenElse(hn::RebindMask(DI(), reflects), hn::Load(DI(), id + i), SetI(-1)), DI(), id + i);
  }
  for (int k = 0; k < scene.mirrored.count; ++k) {
    const Window w = WindowOf(scene.mirrored.aspects[k], tile);
    if (IsEmpty(w)) continue;
    Paint<Brush::kAdd>({&scene, &scene.mirrored, k, &tile, t, id, nullptr, scene.reflectance}, w, canvas);
  }
}

// Transparent things, as MuJoCo blends them: front to back, and then again back to front.
void PaintTransparent(const Scene& scene, const Tile& tile, Canvas& canvas) {
  const int n = scene.transparent_count;
  for (int k = 0; k < 2 * n; ++k) {
    const int index = scene.transparent[k < n ? k : 2 * n - 1 - k];
    const Window w = WindowOf(scene.camera.aspects[index], tile);
    if (IsEmpty(w)) continue;
    alignas(64) float t[kRays];
    alignas(64) std::int32_t id[kRays];
    std::copy_n(tile.t, kRays, t);
    std::fill_n(id, kRays, -1);
    Cast<false>(scene, scene.camera, index, tile, w, &scene.near_plane, t, id);
    Paint<Brush::kBlend>({&scene, &scene.camera, index, &tile, t, id, nullptr, 1.0F}, w, canvas);
  }
}

// Colours of all rays of a tile, as 0x00BBGGRR.
void ColorTile(const Scene& scene, const Tile& tile, std::uint32_t* out) {
  const int lanes = static_cast<int>(hn::Lanes(D()));

  Shade shades[kMaxLights];
  for (int k = 0; k < scene.caster_count; ++k) {
    switch (scene.casters[k].rays) {
      case Rays::kPerspective: CastShadows<Rays::kPerspective>(scene, scene.casters[k], tile, shades[k]); break;
      case Rays::kParallel: CastShadows<Rays::kParallel>(scene, scene.casters[k], tile, shades[k]); break;
      case Rays::kAround: CastShadows<Rays::kAround>(scene, scene.casters[k], tile, shades[k]); break;
    }
  }

  // The sky hides what is farther away than it is.
  alignas(64) std::int32_t shown[kRays];
  bool solids = false;
  bool empty = false;
  for (int i = 0; i < kRays; i += lanes) {
    VI id = hn::Load(DI(), tile.id + i);
    const V t = Load(tile.t + i);
    if (scene.sky_limit > 0 && !All(hn::Lt(t, Set(0.4F * scene.sky_limit)))) {
      const V3 d = Set(scene.sky_a) + Set(scene.sky_by) * Set(tile.y[i / kTile]) +
                   Set(scene.sky_bx) * Load(tile.x + i % kTile);
      const V limit = Set(scene.sky_limit);
      const M hidden = hn::Or(hn::Gt(t * hn::Sqrt(d.x * d.x + d.z * d.z), limit), hn::Gt(t * hn::Abs(d.y), limit));
      id = hn::IfThenElse(hn::RebindMask(DI(), hidden), SetI(-1), id);
    }
    hn::Store(id, DI(), shown + i);
    const auto nothing = hn::Lt(id, hn::Zero(DI()));
    solids = solids || !hn::AllTrue(DI(), nothing);
    empty = empty || !hn::AllFalse(DI(), nothing);
  }

  Canvas canvas;
  if (empty) {
    std::fill_n(canvas.r, kRays, 0.0F);
    std::fill_n(canvas.g, kRays, 0.0F);
    std::fill_n(canvas.b, kRays, 0.0F);
  }
  if (solids) {
    for (int k = 0; k < scene.camera.count; ++k) {
      const Aspect& aspect = scene.camera.aspects[k];
      if (scene.solids[aspect.solid].transparent) continue;
      const Window w = WindowOf(aspect, tile);
      if (IsEmpty(w)) continue;
      Paint<Brush::kPut>({&scene, &scene.camera, k, &tile, tile.t, shown, shades, 1.0F}, w, canvas);
    }
    if (scene.mirror >= 0) PaintMirror(scene, tile, shown, canvas);
    if (scene.fog) PaintFog(scene, tile, shown, canvas);
  }
  if (empty && scene.sky != nullptr) PaintSky(scene, tile, shown, canvas);
  if (scene.haze) PaintHaze(scene, tile, canvas);
  if (scene.transparent_count > 0) PaintTransparent(scene, tile, canvas);

  const V one = Set(1.0F);
  const V scale = Set(255.0F);
  const V half = Set(0.5F);
  for (int i = 0; i < kRays; i += lanes) {
    const VI r = Whole(hn::Min(Load(canvas.r + i), one) * scale + half);
    const VI g = Whole(hn::Min(Load(canvas.g + i), one) * scale + half);
    const VI b = Whole(hn::Min(Load(canvas.b + i), one) * scale + half);
    hn::Store(hn::Or(r, hn::Or(hn::ShiftLeft<8>(g), hn::ShiftLeft<16>(b))), DI(),
              reinterpret_cast<std::int32_t*>(out) + i);
  }
}

void DrawOneTile(const Job& job, int index) {
  const Scene& scene = *job.scene;
  const int tile_row = index / job.tile_columns();
  const int tile_column = index % job.tile_columns();
  Tile tile;
  tile.dx = job.dx;
  tile.dy = job.dy;
  for (int k = 0; k < kTile; ++k) {
    tile.x[k] = job.x + static_cast<float>(tile_column * kTile + k) * job.dx;
    tile.y[k] = job.y + static_cast<float>(tile_row * kTile + k) * job.dy;
  }
  std::fill_n(tile.t, kRays, kMiss);
  std::fill_n(tile.id, kRays, -1);
  for (int k = 0; k < scene.camera.count; ++k) {
    const Aspect& aspect = scene.camera.aspects[k];
    const Window w = WindowOf(aspect, tile);
    if (IsEmpty(w)) continue;
    if (scene.solids[aspect.solid].transparent) continue;
    Cast<false>(scene, scene.camera, k, tile, w, &scene.near_plane, tile.t, tile.id);
  }

  if (job.rgb != nullptr) {
    alignas(64) std::uint32_t color[kRays];
    ColorTile(scene, tile, color);
    WriteColor(job, tile_row, tile_column, color);
  }
  const int width = std::min(kTile, job.columns - tile_column * kTile);
  const int height = std::min(kTile, job.rows - tile_row * kTile);
  if (job.depth != nullptr || job.segmentation != nullptr) {
    for (int k = 0; k < scene.transparent_count; ++k) {
      const int which = scene.transparent[k];
      const Window w = WindowOf(scene.camera.aspects[which], tile);
      if (IsEmpty(w)) continue;
      Cast<false>(scene, scene.camera, which, tile, w, &scene.near_plane, tile.t, tile.id);
    }
    for (int row = 0; row < height; ++row) {
      const std::size_t start = static_cast<std::size_t>(tile_row * kTile + row) * job.columns + tile_column * kTile;
      for (int column = 0; column < width; ++column) {
        const int i = row * kTile + column;
        const bool hit = tile.t[i] <= scene.far_plane;
        if (job.depth != nullptr) job.depth[start + column] = hit ? tile.t[i] : scene.far_plane;
        if (job.segmentation != nullptr) {
          job.segmentation[start + column] = hit ? scene.solids[scene.camera.aspects[tile.id[i]].solid].id : -1;
        }
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::render::ray
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mimo::render::ray {

std::vector<Path> paths() {
  std::vector<Path> result;
#if HWY_ARCH_X86
#if HWY_TARGETS & HWY_AVX3
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd")) {
    result.push_back({"AVX3", &N_AVX3::DrawOneTile});
  }
#endif
#if HWY_TARGETS & HWY_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) {
    result.push_back({"AVX2", &N_AVX2::DrawOneTile});
  }
#endif
#if HWY_TARGETS & HWY_SSE4
  if (__builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul")) {
    result.push_back({"SSE4", &N_SSE4::DrawOneTile});
  }
#endif
#endif
  // What the compiler may assume of every machine that this build is for.
  const char* const baseline = HWY_STATIC_TARGET == HWY_EMU128 ? "portable" : hwy::TargetName(HWY_STATIC_TARGET);
  if (result.empty() || std::strcmp(result.back().name, baseline) != 0) {
    result.push_back({baseline, &HWY_STATIC_DISPATCH(DrawOneTile)});
  }
  return result;
}

}  // namespace mimo::render::ray

#endif  // HWY_ONCE
