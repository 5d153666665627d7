// The colours of a tile's rays.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_CANVAS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_CANVAS_INL_H
#undef MIMO_RAYS_CANVAS_INL_H
#else
#define MIMO_RAYS_CANVAS_INL_H
#endif

#include "rays/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

struct Canvas {
  alignas(64) float r[kRays];
  float g[kRays];
  float b[kRays];
};

enum class Brush { kPut, kAdd, kBlend };

HWY_INLINE V3 AtMostWhite(const V3& color) {
  const V one = Set(1.0F);
  return {hn::Min(color.x, one), hn::Min(color.y, one), hn::Min(color.z, one)};
}

// Puts colour where `mine` holds.
template <Brush kBrush>
HWY_INLINE void Put(const V3& color, M mine, float alpha, int i, Canvas& canvas) {
  if (kBrush == Brush::kPut && All(mine)) {
    Store(color.x, canvas.r + i);
    Store(color.y, canvas.g + i);
    Store(color.z, canvas.b + i);
    return;
  }
  const V3 old = {Load(canvas.r + i), Load(canvas.g + i), Load(canvas.b + i)};
  V3 mixed = color;
  if (kBrush == Brush::kAdd) mixed = color + old;
  if (kBrush == Brush::kBlend) mixed = old * (Set(1.0F) - Set(alpha)) + color * Set(alpha);
  Store(Pick(mine, mixed.x, old.x), canvas.r + i);
  Store(Pick(mine, mixed.y, old.y), canvas.g + i);
  Store(Pick(mine, mixed.z, old.z), canvas.b + i);
}

// Bytes red, green, blue, and one that does not count, of colours up to white.
HWY_INLINE VI Packed(const V3& color) {
  const V scale = Set(255.0F);
  const VI r = Low16(color.x * scale);
  const VI g = Low16(color.y * scale);
  const VI b = Low16(color.z * scale);
  return hn::Or(r, hn::Or(hn::ShiftLeft<8>(g), hn::ShiftLeft<16>(b)));
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
