// Where rays meet solids.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_INTERSECT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_INTERSECT_INL_H
#undef MIMO_RAYS_INTERSECT_INL_H
#else
#define MIMO_RAYS_INTERSECT_INL_H
#endif

#include "rays/lanes-inl.h"
#include "rays/mesh-inl.h"
#include "rays/solids.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

template <Form kForm>
struct FormTag {
  static constexpr Form value = kForm;
};

// Where a ray enters a solid (kMiss where it does not), in the solid's frame. All solids but meshes are
// convex, and what is seen from inside is not drawn: the entry is all there is to know.
template <Form kKind>
HWY_INLINE V Enter(const Solid& solid, const Ray& ray) {
  const V miss = Set(kMiss);
  static_assert(kKind != Form::kMesh);
  V3 o = ray.o;
  V3 d = ray.d;
  if (kKind == Form::kPlane) {
    const V t = (Zero() - o.z) / d.z;
    M hit = hn::Gt(t, Zero());
    if (solid.size[0] > 0) hit = hn::And(hit, hn::Le(hn::Abs(o.x + t * d.x), Set(solid.size[0])));
    if (solid.size[1] > 0) hit = hn::And(hit, hn::Le(hn::Abs(o.y + t * d.y), Set(solid.size[1])));
    return Pick(hit, t, miss);
  }
  if (kKind == Form::kSphere || kKind == Form::kEllipsoid) {
    V r2 = Set(solid.size[0] * solid.size[0]);
    if (kKind == Form::kEllipsoid) {
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
  if (kKind == Form::kCapsule) {
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
  if (kKind == Form::kCylinder) {
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

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
