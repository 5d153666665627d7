// The colours of textures at points of them.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RENDER_RAY_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RENDER_RAY_SAMPLING_INL_H
#undef MIMO_RENDER_RAY_SAMPLING_INL_H
#else
#define MIMO_RENDER_RAY_SAMPLING_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "render/ray/lanes-inl.h"
#include "render/ray/textures.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::render::ray {
namespace HWY_NAMESPACE {

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

#if HWY_TARGET != HWY_SCALAR
// kCount pairs of texels. (Loads one by one are faster than gathers on most machines.)
template <std::size_t kCount>
HWY_INLINE hn::Vec<hn::Simd<std::int64_t, kCount, 0>> FetchPairs(const std::uint32_t* texels, const std::int32_t* at) {
  if constexpr (kCount == 1) {
    return hn::LoadU(hn::Simd<std::int64_t, 1, 0>(), reinterpret_cast<const std::int64_t*>(texels + *at));
  } else {
    return hn::Combine(hn::Simd<std::int64_t, kCount, 0>(), FetchPairs<kCount / 2>(texels, at + kCount / 2),
                       FetchPairs<kCount / 2>(texels, at));
  }
}
#endif

// Texels at `index` and their neighbours to the right, mixed.
HWY_INLINE Texel FetchRow(const std::uint32_t* texels, VI index, VI weight) {
#if HWY_TARGET == HWY_SCALAR
  const std::int32_t* at = reinterpret_cast<const std::int32_t*>(texels) + index.raw;
  return Mix(Unpack(SetI(at[0])), Unpack(SetI(at[1])), weight);
#else
  constexpr std::size_t kHalf = hn::MaxLanes(D()) / 2;
  alignas(64) std::int32_t at[2 * kHalf];
  hn::Store(index, DI(), at);
  const VI a = hn::BitCast(DI(), FetchPairs<kHalf>(texels, at));
  const VI b = hn::BitCast(DI(), FetchPairs<kHalf>(texels, at + kHalf));
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

HWY_INLINE V3 Unpacked(const Texel& texel) {
  const V k = Set(1.0F / 255);
  return {Real(hn::And(texel.rb, SetI(255))) * k, Real(texel.g) * k, Real(hn::ShiftRight<16>(texel.rb)) * k};
}

// Colour 0..1 of a texture at s, t in 0..1 (of a cube's face), where no pixel spans more than a texel.
template <bool kCube>
HWY_INLINE V3 SampleLarge(const std::uint32_t* texels, const Texture& texture, VI face, V s, V t) {
  const Place p = PlaceOf<kCube>(texture, 0, face);
  return Unpacked(Bilinear(texels, p.origin, p.stride, p.width, p.height, s, t));
}

// The same with `spread` the square of the texels that a pixel spans.
template <bool kCube>
HWY_INLINE V3 Sample(const std::uint32_t* texels, const Texture& texture, VI face, V s, V t, V spread) {
  if (texture.levels == 1 || All(hn::Le(spread, Set(1.0F)))) return SampleLarge<kCube>(texels, texture, face, s, t);
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
  return Unpacked(Mix(Bilinear(texels, p.origin, p.stride, p.width, p.height, s, t),
                      Bilinear(texels, q.origin, q.stride, q.width, q.height, s, t), Weight(level - below)));
}

// A cube texture in direction q, which changes by the root of `stretch` from pixel to pixel.
HWY_INLINE V3 SampleCube(const std::uint32_t* texels, const Texture& texture, const V3& q, V stretch) {
  const V ax = hn::Abs(q.x);
  const V ay = hn::Abs(q.y);
  const V az = hn::Abs(q.z);
  const M on_x = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az));
  const M on_y = hn::AndNot(on_x, hn::Ge(ay, az));
  const V major = Pick(on_x, q.x, Pick(on_y, q.y, q.z));
  const M negative = hn::Lt(major, Zero());
  const V minus_z = Zero() - q.z;
  const V sc = Pick(on_x, Pick(negative, q.z, minus_z), Pick(on_y, q.x, Pick(negative, Zero() - q.x, q.x)));
  const V tc = Pick(on_y, Pick(negative, minus_z, q.z), Zero() - q.y);
  const V half = Set(0.5F) / hn::Max(hn::Abs(major), Set(1e-30F));
  VI face = hn::IfThenElse(hn::RebindMask(DI(), on_x), hn::Zero(DI()),
                           hn::IfThenElse(hn::RebindMask(DI(), on_y), SetI(2), SetI(4)));
  face = hn::Add(face, hn::IfThenElse(hn::RebindMask(DI(), negative), SetI(1), hn::Zero(DI())));
  const V texels_each = half * Set(static_cast<float>(texture.width));
  return Sample<true>(texels, texture, face, sc * half + Set(0.5F), tc * half + Set(0.5F),
                      stretch * (texels_each * texels_each));
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::render::ray
HWY_AFTER_NAMESPACE();

#endif
