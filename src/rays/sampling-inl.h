// The colours of textures at points of them.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_SAMPLING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_SAMPLING_INL_H
#undef MIMO_RAYS_SAMPLING_INL_H
#else
#define MIMO_RAYS_SAMPLING_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "rays/lanes-inl.h"
#include "rays/materials.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// Full brightness in the 16-bit numbers that filtering works with: that of a texel times the sum of two weights.
constexpr std::int32_t kWeights = 127;
constexpr std::int32_t kFull = 255 * kWeights;

// The weight of a fraction 0..1 in 1/32768, in the lower 16 bits.
HWY_INLINE VI Weight(V fraction) { return Low16(fraction * Set(32767.0F)); }

// The weight of a texel's neighbour to the right, in the lowest byte; the texel's own is what is left of all.
HWY_INLINE VI PairWeight(V fraction) { return Low16(fraction * Set(static_cast<float>(kWeights))); }

// Light 0..kBrightest as the weight of Lighted().
constexpr float kBrightest = 1.9999F;
// From the half of a filtered colour to bytes, in 1/32768.
constexpr std::int32_t kByte = 516;
HWY_INLINE VI LightWeight(V light) { return Low16(hn::Min(light, Set(kBrightest)) * Set(16384.0F)); }

#if HWY_TARGET == HWY_SCALAR

struct Texel {
  std::int32_t channel[3];
};

HWY_INLINE Texel Mix(const Texel& a, const Texel& b, VI weight) {
  Texel mixed;
  for (int k = 0; k < 3; ++k) {
    mixed.channel[k] = a.channel[k] + (((b.channel[k] - a.channel[k]) * (weight.raw & 0xFFFF) + 0x4000) >> 15);
  }
  return mixed;
}

HWY_INLINE Texel FetchRow(const std::uint32_t* texels, const std::uint32_t* at, VI weights) {
  const std::int32_t weight = weights.raw & 255;
  Texel texel;
  for (int k = 0; k < 3; ++k) {
    const std::int32_t left = texels[*at] >> (8 * k) & 255;
    const std::int32_t right = texels[*at + 1] >> (8 * k) & 255;
    texel.channel[k] = left * (kWeights - weight) + right * weight;
  }
  return texel;
}

HWY_INLINE VI Lighted(const Texel& texel, VI light) {
  std::int32_t bytes = 0;
  for (int k = 0; k < 3; ++k) {
    const std::int32_t half = (texel.channel[k] * (light.raw & 0xFFFF) + 0x4000) >> 15;
    bytes |= std::min((half * kByte + 0x4000) >> 15, 255) << (8 * k);
  }
  return SetI(bytes);
}

HWY_INLINE VI Unlighted(const Texel& texel) {
  std::int32_t bytes = 0;
  for (int k = 0; k < 3; ++k) bytes |= (texel.channel[k] + kWeights / 2) / kWeights << (8 * k);
  return SetI(bytes);
}

HWY_INLINE V3 Unpacked(const Texel& texel) {
  const V k = Set(1.0F / kFull);
  return {Real(SetI(texel.channel[0])) * k, Real(SetI(texel.channel[1])) * k, Real(SetI(texel.channel[2])) * k};
}

#else

using DB = hn::Repartition<std::uint8_t, D>;
using DS = hn::Repartition<std::int16_t, D>;

// Filtered colours, 16 bits a channel. Of each four pixels `low` has the first two and `high` the others: what
// interleaving gives without crossing the blocks of 16 bytes of which vectors are made.
struct Texel {
  hn::Vec<DS> low, high;
};

// The lower 16 bits of each pixel's number, four times, for two pixels out of four.
HWY_INLINE hn::Vec<DB> FourTimes(VI v, const std::uint8_t (&order)[16]) {
  return hn::TableLookupBytes(hn::BitCast(DB(), v), hn::LoadDup128(DB(), order));
}
alignas(16) constexpr std::uint8_t kLow[16] = {0, 1, 0, 1, 0, 1, 0, 1, 4, 5, 4, 5, 4, 5, 4, 5};
alignas(16) constexpr std::uint8_t kHigh[16] = {8, 9, 8, 9, 8, 9, 8, 9, 12, 13, 12, 13, 12, 13, 12, 13};

// a + (b - a) weight.
HWY_INLINE Texel Mix(const Texel& a, const Texel& b, VI weight) {
  const auto low = hn::BitCast(DS(), FourTimes(weight, kLow));
  const auto high = hn::BitCast(DS(), FourTimes(weight, kHigh));
  return {hn::Add(a.low, hn::MulFixedPoint15(hn::Sub(b.low, a.low), low)),
          hn::Add(a.high, hn::MulFixedPoint15(hn::Sub(b.high, a.high), high))};
}

// Sums of products of neighbouring bytes, those of b at most 127. (Highway has this from 1.0.8 on.)
HWY_INLINE hn::Vec<DS> MulPairs(hn::Vec<DB> a, hn::Vec<DB> b) {
#if HWY_TARGET == HWY_AVX3
  return hn::Vec<DS>{_mm512_maddubs_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_AVX2
  return hn::Vec<DS>{_mm256_maddubs_epi16(a.raw, b.raw)};
#elif HWY_TARGET == HWY_SSE4
  return hn::Vec<DS>{_mm_maddubs_epi16(a.raw, b.raw)};
#else
  const auto first = hn::Set(DS(), 255);
  const auto left = hn::BitCast(DS(), a);
  const auto right = hn::BitCast(DS(), b);
  return hn::Add(hn::Mul(hn::And(left, first), hn::And(right, first)),
                 hn::Mul(hn::And(hn::ShiftRight<8>(left), first), hn::And(hn::ShiftRight<8>(right), first)));
#endif
}

// Texels and their neighbours to the right, of two pixels out of four. (Loads one by one are faster than gathers on
// most machines.)
template <std::size_t kCount>
HWY_INLINE hn::Vec<hn::Simd<std::int64_t, kCount, 0> > FetchPairs(const std::uint32_t* texels,
                                                                  const std::uint32_t* at) {
  if constexpr (kCount == 2) {
    const hn::Simd<std::int64_t, 1, 0> one;
    return hn::Combine(hn::Simd<std::int64_t, 2, 0>(),
                       hn::LoadU(one, reinterpret_cast<const std::int64_t*>(texels + at[1])),
                       hn::LoadU(one, reinterpret_cast<const std::int64_t*>(texels + at[0])));
  } else {
    return hn::Combine(hn::Simd<std::int64_t, kCount, 0>(), FetchPairs<kCount / 2>(texels, at + kCount),
                       FetchPairs<kCount / 2>(texels, at));
  }
}

// The weights of texels and their neighbours to the right, in turns, for two pixels out of four.
HWY_INLINE hn::Vec<DB> InTurns(VI weights, const std::uint8_t (&order)[16]) {
  const auto right = hn::TableLookupBytes(hn::BitCast(DB(), weights), hn::LoadDup128(DB(), order));
  return hn::Xor(right, hn::BitCast(DB(), hn::Set(DS(), kWeights)));  // kWeights - w = kWeights ^ w
}
alignas(16) constexpr std::uint8_t kLowByte[16] = {0, 0, 0, 0, 0, 0, 0, 0, 4, 4, 4, 4, 4, 4, 4, 4};
alignas(16) constexpr std::uint8_t kHighByte[16] = {8, 8, 8, 8, 8, 8, 8, 8, 12, 12, 12, 12, 12, 12, 12, 12};

// Texels and their neighbours to the right, mixed.
HWY_INLINE Texel FetchRow(const std::uint32_t* texels, const std::uint32_t* at, VI weights) {
  constexpr std::size_t kPairs = hn::MaxLanes(D()) / 2;
  alignas(16) static constexpr std::uint8_t kSideBySide[16] = {0, 4, 1, 5, 2, 6, 3, 7, 8, 12, 9, 13, 10, 14, 11, 15};
  const auto order = hn::LoadDup128(DB(), kSideBySide);
  const auto low = hn::TableLookupBytes(hn::BitCast(DB(), FetchPairs<kPairs>(texels, at)), order);
  const auto high = hn::TableLookupBytes(hn::BitCast(DB(), FetchPairs<kPairs>(texels, at + 2)), order);
  return {MulPairs(low, InTurns(weights, kLowByte)), MulPairs(high, InTurns(weights, kHighByte))};
}

// The channels of pixels as bytes, cut at 255.
HWY_INLINE hn::Vec<DB> Bytes(hn::Vec<DS> low, hn::Vec<DS> high) {
#if HWY_TARGET == HWY_AVX3
  return hn::Vec<DB>{_mm512_packus_epi16(low.raw, high.raw)};
#elif HWY_TARGET == HWY_AVX2
  return hn::Vec<DB>{_mm256_packus_epi16(low.raw, high.raw)};
#elif HWY_TARGET == HWY_SSE4
  return hn::Vec<DB>{_mm_packus_epi16(low.raw, high.raw)};
#else
  alignas(16) static constexpr std::uint8_t kLower[16] = {0,   2,   4,   6,   8,   10,  12,  14,
                                                          128, 128, 128, 128, 128, 128, 128, 128};
  alignas(16) static constexpr std::uint8_t kUpper[16] = {128, 128, 128, 128, 128, 128, 128, 128,
                                                          0,   2,   4,   6,   8,   10,  12,  14};
  const auto cut = [](hn::Vec<DS> v) { return hn::BitCast(DB(), hn::Min(v, hn::Set(DS(), 255))); };
  return hn::Or(hn::TableLookupBytesOr0(cut(low), hn::LoadDup128(DB(), kLower)),
                hn::TableLookupBytesOr0(cut(high), hn::LoadDup128(DB(), kUpper)));
#endif
}

// Filtered colours in grey light: bytes as Packed() gives them, cut at white.
HWY_INLINE VI Lighted(const Texel& texel, VI light) {
  const auto byte = hn::Set(DS(), kByte);
  const auto half = [&](hn::Vec<DS> channels, const std::uint8_t(&order)[16]) {
    return hn::MulFixedPoint15(channels, hn::BitCast(DS(), FourTimes(light, order)));
  };
  const auto low = hn::MulFixedPoint15(half(texel.low, kLow), byte);
  const auto high = hn::MulFixedPoint15(half(texel.high, kHigh), byte);
  return hn::BitCast(DI(), Bytes(low, high));
}

// Filtered colours as they are: the bytes that Packed(Unpacked(texel)) gives, in a third of the time.
HWY_INLINE VI Unlighted(const Texel& texel) {
  // 258 / 32768 is a hair less than 1 / kWeights, by which up to 2 of kFull are missing.
  const auto rounded = [](hn::Vec<DS> channels) {
    const auto missing = hn::MulFixedPoint15(channels, hn::Set(DS(), 2));
    return hn::MulFixedPoint15(hn::Add(channels, missing), hn::Set(DS(), kByte / 2));
  };
  return hn::BitCast(DI(), Bytes(rounded(texel.low), rounded(texel.high)));
}

HWY_INLINE V3 Unpacked(const Texel& texel) {
  const VI low = hn::BitCast(DI(), texel.low);
  const VI high = hn::BitCast(DI(), texel.high);
  const VI even = hn::InterleaveLower(DI(), low, high);
  const VI odd = hn::InterleaveUpper(DI(), low, high);
  const VI rg = hn::InterleaveLower(DI(), even, odd);
  const VI b = hn::InterleaveUpper(DI(), even, odd);
  const V k = Set(1.0F / kFull);
  return {Real(hn::And(rg, SetI(0xFFFF))) * k, Real(hn::ShiftRight<16>(rg)) * k, Real(b) * k};
}

#endif

// Where one begins, less what Marked() adds to the places in it; and its size.
struct Mipmap {
  VI origin, stride;
  V width, height;
};

// A whole number in -2^22..2^22, and kMark. (The mark is taken off where it costs nothing.)
constexpr std::uint32_t kMark = 0x4B400000;
HWY_INLINE VI Marked(V whole) { return hn::BitCast(DI(), whole + Set(12582912.0F)); }

template <bool kCube>
HWY_INLINE Mipmap MipmapOf(const Texture& texture, int level, VI face) {
  const int width = std::max(texture.width >> level, 1);
  const int height = std::max(texture.height >> level, 1);
  const std::uint32_t marks = kMark * static_cast<std::uint32_t>(width + 3);
  VI origin = SetI(static_cast<std::int32_t>(static_cast<std::uint32_t>(texture.origin[level]) - marks));
  if (kCube) origin = hn::Add(origin, hn::Mul(face, SetI((width + 2) * (height + 2))));
  return {origin, SetI(width + 2), Set(static_cast<float>(width)), Set(static_cast<float>(height))};
}

template <bool kCube>
HWY_NOINLINE Mipmap MipmapOf(const Texture& texture, VI level, VI face) {
  const VI one = SetI(1);
  const VI two = SetI(2);
  const VI width = hn::Max(hn::Shr(SetI(texture.width), level), one);
  const VI height = hn::Max(hn::Shr(SetI(texture.height), level), one);
  VI origin = hn::GatherIndex(DI(), texture.origin.data(), level);
  if (kCube) origin = hn::Add(origin, hn::Mul(face, hn::Mul(hn::Add(width, two), hn::Add(height, two))));
  origin = hn::Sub(origin, hn::Mul(hn::Add(width, SetI(3)), SetI(static_cast<std::int32_t>(kMark))));
  return {origin, hn::Add(width, two), Real(width), Real(height)};
}

// The four texels between which a point lies, and their weights.
struct Tap {
  VI upper, lower;  // index of the left ones
  VI weights;       // of the right ones
  VI mix;           // of upper and lower
};

// With s and t in 0..1.
HWY_INLINE Tap Aim(const Mipmap& mipmap, V s, V t) {
  const V u = s * mipmap.width - Set(0.5F);
  const V v = t * mipmap.height - Set(0.5F);
  const V u0 = hn::Floor(u);
  const V v0 = hn::Floor(v);
  const VI upper = hn::Add(hn::Add(mipmap.origin, Marked(u0)), hn::Mul(Marked(v0), mipmap.stride));
  return {upper, hn::Add(upper, mipmap.stride), PairWeight(u - u0), Weight(v - v0)};
}

HWY_INLINE Texel Fetch(const std::uint32_t* texels, const Tap& tap) {
  alignas(64) std::uint32_t upper[hn::MaxLanes(D())];
  alignas(64) std::uint32_t lower[hn::MaxLanes(D())];
  hn::Store(hn::BitCast(DU(), tap.upper), DU(), upper);
  hn::Store(hn::BitCast(DU(), tap.lower), DU(), lower);
  asm("" : "+m"(upper), "+m"(lower));  // through memory: to take a vector apart costs more
  return Mix(FetchRow(texels, upper, tap.weights), FetchRow(texels, lower, tap.weights), tap.mix);
}

// 0..1, also of rays whose result is not used, and which may be anything: they must not fetch from nowhere.
HWY_INLINE V Inside(V s) { return hn::Min(hn::IfThenElseZero(hn::Gt(s, Zero()), s), Set(1.0F)); }

// The mipmap for pixels that span so many texels (squared).
HWY_INLINE V LevelOf(V spread) {
  if (All(hn::Le(spread, Set(1.0F)))) return Zero();
  return Set(0.5F) * Log2(hn::Min(hn::Max(spread, Set(1.0F)), Set(1e12F)));
}

// At s, t in 0..1 (of a cube's face), where no pixel spans more than a texel.
template <bool kCube>
HWY_INLINE Tap AimLarge(const Texture& texture, VI face, V s, V t) {
  return Aim(MipmapOf<kCube>(texture, 0, face), Inside(s), Inside(t));
}

// The same for a mipmap between two.
struct Taps {
  Tap fine, coarse;
  VI mix;
};

template <bool kCube>
HWY_INLINE Taps AimBetween(const Texture& texture, VI face, V s, V t, V wanted) {
  s = Inside(s);
  t = Inside(t);
  const V level = hn::Min(hn::Max(wanted, Zero()), Set(static_cast<float>(texture.levels - 1)));
  const V below = hn::Floor(level);
  const VI l0 = Whole(below);
  const VI mix = Weight(level - below);
  const int first = hn::GetLane(l0);
  if (hn::AllTrue(DI(), hn::Eq(l0, SetI(first)))) {
    return {Aim(MipmapOf<kCube>(texture, first, face), s, t),
            Aim(MipmapOf<kCube>(texture, std::min(first + 1, texture.levels - 1), face), s, t), mix};
  }
  const VI l1 = hn::Min(hn::Add(l0, SetI(1)), SetI(texture.levels - 1));
  return {Aim(MipmapOf<kCube>(texture, l0, face), s, t), Aim(MipmapOf<kCube>(texture, l1, face), s, t), mix};
}

// Colour where no pixel spans more than a texel.
template <bool kCube>
HWY_INLINE Texel FilterLarge(const std::uint32_t* texels, const Texture& texture, VI face, V s, V t) {
  return Fetch(texels, AimLarge<kCube>(texture, face, s, t));
}

// Colour at any mipmap.
template <bool kCube>
HWY_INLINE Texel Filter(const std::uint32_t* texels, const Texture& texture, VI face, V s, V t, V wanted) {
  if (texture.levels == 1 || All(hn::Le(wanted, Zero()))) return FilterLarge<kCube>(texels, texture, face, s, t);
  const Taps taps = AimBetween<kCube>(texture, face, s, t, wanted);
  return Mix(Fetch(texels, taps.fine), Fetch(texels, taps.coarse), taps.mix);
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
  return Unpacked(Filter<true>(texels, texture, face, sc * half + Set(0.5F), tc * half + Set(0.5F),
                               LevelOf(stretch * (texels_each * texels_each))));
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
