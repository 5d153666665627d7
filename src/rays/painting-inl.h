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
#include "rays/smooth-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

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
      const V3 ray =
          Set(aspect.a) + Set(aspect.by) * Set(subject.tile->y[row]) + Set(aspect.bx) * Load(subject.tile->x + column);
      const V3 p = Set(aspect.o) + ray * t;
      V3 n;
      if constexpr (kKind == Form::kMesh) {
        n = SurfaceAt(*solid.mesh, FaceAt(subject, i), p).normal();
      } else {
        n = Normal<kKind>(solid, p);
      }
      V3 color = Lit<kKind, kGray>(subject, aspect, ray, p, n, i);
      if (solid.material.mapping.kind != Mapping::kNone) {
        const V3 texel = Textured<kKind>(subject, aspect, ray, p, n, t, i);
        color = {color.x * texel.x, color.y * texel.y, color.z * texel.z};
      }
      color = AtMostWhite(color);
      if (kBrush != Brush::kPut && frame.backdrop.fog.shown) color = Fogged(frame.backdrop.fog, color, t);
      Put<kBrush>(color, mine, solid.material.alpha, i, canvas);
    }
  }
}

// The light of a plane in a tile where it is smooth. Shadows are those of each ray.
HWY_NOINLINE void PaintSmoothLight(const Subject& subject, const Smooth& smooth, const Window& w, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const Frame& frame = *subject.frame;
  for (int row = w.row0; row <= w.row1; ++row) {
    for (int column = w.column0 / lanes * lanes; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      const M mine = Mine(subject, i);
      if (None(mine)) continue;
      const V x = AcrossTile(column);
      V3 color = ColorAt(smooth.color, smooth.channels, row, x);
      for (int k = 0; k < frame.lights.caster_count(); ++k) {
        if (!smooth.reached[k]) continue;
        color = color + ColorAt(smooth.extra[k], smooth.channels, row, x) * LitAt(subject.shades[k], i);
      }
      Put<Brush::kPut>(color, mine, 1.0F, i, canvas);
    }
  }
}

// Its flat texture, by which what is there is multiplied.
HWY_NOINLINE void PaintSmoothTexture(const Subject& subject, const Smooth& smooth, const Window& w, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const Aspect& aspect = subject.eye->aspects[subject.index];
  const Material& material = subject.frame->solids[aspect.solid].material;
  const Texture& texture = *material.texture;
  const std::uint32_t* const texels = subject.frame->texels;
  const VI face = hn::Zero(DI());
  const int first = w.column0 / lanes * lanes;
  TapStore fine;
  TapStore coarse;
  alignas(64) std::int32_t mix[kRays];
  bool large[kTile];
  for (int row = w.row0; row <= w.row1; ++row) {
    const V y = Set(subject.tile->y[row]);
    large[row] = true;
    for (int column = first; column <= w.column1 && large[row]; column += lanes) {
      large[row] = texture.levels == 1 || All(hn::Le(At(smooth.level, row, AcrossTile(column)), Zero()));
    }
    for (int column = first; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      if (None(Mine(subject, i))) continue;
      const V x = Load(subject.tile->x + column);
      const V t = Load(subject.t + i);
      const V px = Set(aspect.o[0]) + (Set(aspect.a[0]) + Set(aspect.by[0]) * y + Set(aspect.bx[0]) * x) * t;
      const V py = Set(aspect.o[1]) + (Set(aspect.a[1]) + Set(aspect.by[1]) * y + Set(aspect.bx[1]) * x) * t;
      const V u = Repeated(px * Set(material.mapping.scale[0]) - Set(0.5F));
      const V v = Repeated(py * Set(material.mapping.scale[1]) - Set(0.5F));
      if (large[row]) {
        fine.put(AimLarge<false>(texture, face, u, v), i);
      } else {
        const Taps taps = AimBetween<false>(texture, face, u, v, At(smooth.level, row, AcrossTile(column)));
        fine.put(taps.fine, i);
        coarse.put(taps.coarse, i);
        hn::Store(taps.mix, DI(), mix + i);
      }
    }
  }
  for (int row = w.row0; row <= w.row1; ++row) {
    for (int column = first; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      const M mine = Mine(subject, i);
      if (None(mine)) continue;
      Texel filtered = fine.fetch(texels, i);
      if (!large[row]) filtered = Mix(filtered, coarse.fetch(texels, i), hn::Load(DI(), mix + i));
      const V3 texel = Unpacked(filtered);
      const V3 light = {Load(canvas.r + i), Load(canvas.g + i), Load(canvas.b + i)};
      const V3 color = AtMostWhite({light.x * texel.x, light.y * texel.y, light.z * texel.z});
      Put<Brush::kPut>(color, mine, 1.0F, i, canvas);
    }
  }
}

HWY_INLINE std::size_t CountMine(const Subject& subject) {
  std::size_t count = 0;
  for (int i = 0; i < kRays; i += static_cast<int>(hn::Lanes(D()))) count += hn::CountTrue(D(), Mine(subject, i));
  return count;
}

// Whether that was all there is to do. For few rays it is not worth while.
inline bool PaintSmoothPlane(const Subject& subject, const Window& w, Canvas& canvas) {
  const Aspect& aspect = subject.eye->aspects[subject.index];
  const Material& material = subject.frame->solids[aspect.solid].material;
  const std::size_t count = CountMine(subject);
  if (count < kRays / 8) return count == 0;
  Probes probes;
  Smooth smooth;
  if (!Probe(aspect, *subject.tile, probes) || !SmoothLight(subject, aspect, probes, smooth)) return false;
  if (material.mapping.kind == Mapping::kCube) return false;
  if (material.mapping.kind == Mapping::kFlat && !SmoothLevel(subject, aspect, probes, smooth)) return false;
  PaintSmoothLight(subject, smooth, w, canvas);
  if (material.mapping.kind == Mapping::kFlat) PaintSmoothTexture(subject, smooth, w, canvas);
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
void Paint(const Subject& subject, const Window& w, Canvas& canvas) {
  switch (subject.frame->solids[subject.eye->aspects[subject.index].solid].kind) {
    case Form::kPlane:
      if (kBrush == Brush::kPut && PaintSmoothPlane(subject, w, canvas)) break;
      PaintGrayOrNot<Form::kPlane, kBrush>(subject, w, canvas);
      break;
    case Form::kSphere: PaintGrayOrNot<Form::kSphere, kBrush>(subject, w, canvas); break;
    case Form::kCapsule: PaintGrayOrNot<Form::kCapsule, kBrush>(subject, w, canvas); break;
    case Form::kEllipsoid: PaintGrayOrNot<Form::kEllipsoid, kBrush>(subject, w, canvas); break;
    case Form::kCylinder: PaintGrayOrNot<Form::kCylinder, kBrush>(subject, w, canvas); break;
    case Form::kBox: PaintGrayOrNot<Form::kBox, kBrush>(subject, w, canvas); break;
    case Form::kMesh: PaintGrayOrNot<Form::kMesh, kBrush>(subject, w, canvas); break;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
