// Solids, painted onto the colours of a tile.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_PAINTING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_PAINTING_INL_H
#undef MIMO_RAYS_PAINTING_INL_H
#else
#define MIMO_RAYS_PAINTING_INL_H
#endif

#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/lighting-inl.h"
#include "rays/planes-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

template <Form kKind, bool kGray, Brush kBrush>
HWY_NOINLINE void PaintKind(Subject subject, const Window& w, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const Aspect& aspect = subject.eye->aspects[subject.index];
  const Frame& frame = *subject.frame;
  const Solid& solid = frame.solids[aspect.solid];
  if (kKind == Form::kPlane) subject.sharp = SharpUpTo(subject, aspect);
  for (int row = w.row0; row <= w.row1; ++row) {
    for (int column = w.column0 / lanes * lanes; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      const M mine = Mine(subject, i);
      if (None(mine)) continue;
      const V t = Load(subject.t + i);
      const Ray ray = RayAcross(
          aspect, *subject.tile,
          Set(aspect.a) + Set(aspect.by) * Set(subject.tile->y[row]) + Set(aspect.bx) * Load(subject.tile->x + column));
      const V3 p = ray.o + ray.d * t;
      // Highlights are those of an eye where the camera is, even if its rays are parallel: so OpenGL has it.
      const V3 seen = subject.tile->parallel ? p - Set(aspect.a) : ray.d;
      V3 n;
      if constexpr (kKind == Form::kMesh) {
        n = subject.normals->at(i);
      } else {
        n = Normal<kKind>(solid, p);
      }
      V3 color = Lit<kKind, kGray>(subject, aspect, seen, p, n, i);
      if (solid.material.mapping.kind != Mapping::kNone) {
        const V3 texel = Textured<kKind>(subject, aspect, ray.d, p, n, t, i);
        color = {color.x * texel.x, color.y * texel.y, color.z * texel.z};
      }
      color = AtMostWhite(color);
      if (kBrush != Brush::kPut && frame.backdrop.fog.shown) color = Fogged(frame.backdrop.fog, color, t);
      Put<kBrush>(color, mine, solid.material.alpha, i, canvas);
    }
  }
}

HWY_INLINE std::size_t CountMine(const Subject& subject) {
  std::size_t count = 0;
  for (int i = 0; i < kRays; i += static_cast<int>(hn::Lanes(D()))) count += hn::CountTrue(D(), Mine(subject, i));
  return count;
}

// Whether that was all there is to do. For few rays it is not worth while.
inline bool PaintSmoothPlane(const Subject& subject, Canvas& canvas) {
  const std::size_t count = CountMine(subject);
  if (count < kRays / 8) return count == 0;
  Smooth own;
  const Smooth* smooth = SmoothAcross(subject, own);
  if (smooth == nullptr) return false;
  PaintSmooth(subject, *smooth, canvas);
  return true;
}

template <Form kKind, Brush kBrush>
HWY_INLINE void PaintGrayOrNot(const Subject& subject, const Window& w, Canvas& canvas) {
  if (subject.frame->lights.gray()) {
    PaintKind<kKind, true, kBrush>(subject, w, canvas);
  } else {
    PaintKind<kKind, false, kBrush>(subject, w, canvas);
  }
}

template <Brush kBrush>
void PaintMesh(Subject subject, const Window& w, Canvas& canvas) {
  Normals own;
  if (subject.normals == nullptr) {
    FindNormals(*subject.frame, subject.eye->aspects[subject.index], subject.index,
                {subject.tile, subject.t, subject.id, subject.face}, w, own, nullptr);
    subject.normals = &own;
  }
  PaintGrayOrNot<Form::kMesh, kBrush>(subject, w, canvas);
}

template <Brush kBrush>
void Paint(const Subject& subject, const Window& w, Canvas& canvas) {
  switch (subject.frame->solids[subject.eye->aspects[subject.index].solid].kind) {
    case Form::kPlane:
      if (kBrush == Brush::kPut && PaintSmoothPlane(subject, canvas)) break;
      PaintGrayOrNot<Form::kPlane, kBrush>(subject, w, canvas);
      break;
    case Form::kSphere: PaintGrayOrNot<Form::kSphere, kBrush>(subject, w, canvas); break;
    case Form::kCapsule: PaintGrayOrNot<Form::kCapsule, kBrush>(subject, w, canvas); break;
    case Form::kEllipsoid: PaintGrayOrNot<Form::kEllipsoid, kBrush>(subject, w, canvas); break;
    case Form::kCylinder: PaintGrayOrNot<Form::kCylinder, kBrush>(subject, w, canvas); break;
    case Form::kBox: PaintGrayOrNot<Form::kBox, kBrush>(subject, w, canvas); break;
    case Form::kMesh: PaintMesh<kBrush>(subject, w, canvas); break;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
