// Solids, painted onto the colours of a tile.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RENDER_RAY_PAINTING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RENDER_RAY_PAINTING_INL_H
#undef MIMO_RENDER_RAY_PAINTING_INL_H
#else
#define MIMO_RENDER_RAY_PAINTING_INL_H
#endif

#include "render/ray/lanes-inl.h"
#include "render/ray/lighting-inl.h"
#include "render/ray/scene.h"
#include "render/ray/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::render::ray {
namespace HWY_NAMESPACE {

template <Kind kKind, bool kGray, Brush kBrush>
HWY_NOINLINE void PaintKind(Subject subject, const Window& w, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const Aspect& aspect = subject.eye->aspects[subject.index];
  const Solid& solid = subject.scene->solids[aspect.solid];
  const V one = Set(1.0F);
  if (kKind == Kind::kPlane) subject.sharp = SharpUpTo(subject, aspect);
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
      if (kBrush == Brush::kPut && All(mine)) {
        Store(color.x, canvas.r + i);
        Store(color.y, canvas.g + i);
        Store(color.z, canvas.b + i);
        continue;
      }
      const V3 old = {Load(canvas.r + i), Load(canvas.g + i), Load(canvas.b + i)};
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

}  // namespace HWY_NAMESPACE
}  // namespace mimo::render::ray
HWY_AFTER_NAMESPACE();

#endif
