// A vector of rays: short names for what is done with numbers of which each ray has its own.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_LANES_INL_H
#undef MIMO_RAYS_LANES_INL_H
#else
#define MIMO_RAYS_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <cstdint>

#include "rays/kernels.h"
#include "rays/materials.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
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
// A whole number v >= 0, or the nearest one, in the lower 16 bits; what is above them is of no use.
HWY_INLINE VI Low16(V v) { return hn::BitCast(DI(), hn::Add(v, hn::Set(D(), 8388608.0F))); }
// The whole number nearest to v in -2^22..2^22. (Conversions look after overflows, which takes five instructions more.)
HWY_INLINE VI Whole(V v) {
  return hn::Sub(hn::BitCast(DI(), hn::Add(v, hn::Set(D(), 12582912.0F))), hn::Set(DI(), 0x4B400000));
}
HWY_INLINE V Real(VI v) { return hn::ConvertTo(D(), v); }
HWY_INLINE VI SetI(int v) { return hn::Set(DI(), v); }
HWY_INLINE V Zero() { return hn::Zero(D()); }
HWY_INLINE V Load(const float* p) { return hn::Load(D(), p); }
HWY_INLINE void Store(V v, float* p) { hn::Store(v, D(), p); }
HWY_INLINE V Pick(M m, V a, V b) { return hn::IfThenElse(m, a, b); }
HWY_INLINE bool None(M m) { return hn::AllFalse(D(), m); }
HWY_INLINE bool All(M m) { return hn::AllTrue(D(), m); }

// Calls of(lane) for those that a mask tells, the first one first.
template <class Of>
HWY_INLINE void EachLane(M m, const Of& of) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(D(), m, bytes);
  std::uint32_t bits = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
  for (; bits != 0; bits &= bits - 1) of(static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits)));
}

struct V3 {
  V x, y, z;
};
HWY_INLINE V3 Set(const std::array<float, 3>& v) { return {Set(v[0]), Set(v[1]), Set(v[2])}; }
HWY_INLINE V Dot(const V3& a, const V3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE V3 operator-(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE V3 operator*(const V3& a, const V3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
HWY_INLINE V3 operator*(const V3& a, V k) { return {a.x * k, a.y * k, a.z * k}; }
HWY_INLINE V3 Pick(M m, const V3& a, const V3& b) { return {Pick(m, a.x, b.x), Pick(m, a.y, b.y), Pick(m, a.z, b.z)}; }

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
               Set(0.69315308F)) *
                  f +
              Set(0.99999994F);
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

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
