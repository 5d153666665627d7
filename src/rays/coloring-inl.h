// The colours of a tile, layer by layer.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_COLORING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_COLORING_INL_H
#undef MIMO_RAYS_COLORING_INL_H
#else
#define MIMO_RAYS_COLORING_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "rays/backdrop-inl.h"
#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/painting-inl.h"
#include "rays/shadows-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// The mirror's reflections, where the tile shows the mirror.
void PaintMirror(const Frame& frame, const Tile& tile, const std::int32_t* shown, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const int mirror = frame.camera.seen[frame.mirror.solid];
  if (mirror < 0) return;
  const Window all = WindowOf(frame.camera.aspects[mirror], tile);
  if (IsEmpty(all)) return;
  alignas(64) float t[kRays];
  alignas(64) std::int32_t id[kRays];
  alignas(64) std::int32_t face[kRays];
  bool any = false;
  for (int k = 0; k < frame.mirror.eye.count; ++k) {
    const Window w = WindowOf(frame.mirror.eye.aspects[k], tile);
    if (IsEmpty(w)) continue;
    if (!any) {
      any = true;
      std::fill_n(t, kRays, kMiss);
      std::fill_n(id, kRays, -1);
      if (frame.solids.meshes()) std::fill_n(face, kRays, 0);
    }
    Cast<true>(frame.solids, frame.mirror.eye, k, tile, w, tile.t, t, id, face);
  }
  if (!any) return;
  // Of a box, only the upper face mirrors.
  const Solid& solid = frame.solids[frame.mirror.solid];
  const Aspect& aspect = frame.camera.aspects[mirror];
  const V upper = Set(solid.kind == Form::kBox ? solid.size[2] * 0.9999F : -kMiss);
  for (int i = 0; i < kRays; i += lanes) {
    const V across =
        Set(aspect.a[2]) + Set(aspect.by[2]) * Set(tile.y[i / kTile]) + Set(aspect.bx[2]) * Load(tile.x + i % kTile);
    const V start = tile.parallel ? across : Set(aspect.o[2]);
    const V z = start + Load(tile.t + i) * (tile.parallel ? Set(aspect.o[2]) : across);
    M reflects = hn::RebindMask(D(), hn::Eq(hn::Load(DI(), shown + i), SetI(mirror)));
    reflects = hn::And(reflects, hn::Gt(z, upper));
    hn::Store(hn::IfThenElse(hn::RebindMask(DI(), reflects), hn::Load(DI(), id + i), SetI(-1)), DI(), id + i);
  }
  for (int k = 0; k < frame.mirror.eye.count; ++k) {
    const Window w = WindowOf(frame.mirror.eye.aspects[k], tile);
    if (IsEmpty(w)) continue;
    Paint<Brush::kAdd>({&frame, &frame.mirror.eye, k, &tile, t, id, face, nullptr, nullptr, frame.mirror.reflectance},
                       w, canvas);
  }
}

// Transparent things, as MuJoCo blends them: front to back, and then again back to front.
void PaintTransparent(const Frame& frame, const Tile& tile, Canvas& canvas) {
  const int n = frame.camera.transparent_count;
  alignas(64) float t[kRays];
  alignas(64) std::int32_t id[kRays];
  alignas(64) std::int32_t face[kRays];
  int known = -1;  // where it is met; the one at the turn comes twice
  for (int k = 0; k < 2 * n; ++k) {
    const int index = frame.camera.transparent[k < n ? k : 2 * n - 1 - k];
    const Window w = WindowOf(frame.camera.aspects[index], tile);
    if (IsEmpty(w)) continue;
    if (index != known) {
      std::copy_n(tile.t, kRays, t);
      std::fill_n(id, kRays, -1);
      if (frame.solids.meshes()) std::fill_n(face, kRays, 0);
      Cast<false>(frame.solids, frame.camera, index, tile, w, &frame.camera.near_plane, t, id, face);
      known = index;
    }
    Paint<Brush::kBlend>({&frame, &frame.camera, index, &tile, t, id, face, nullptr, nullptr, 1.0F}, w, canvas);
  }
}

// The aspects that a tile shows, once each.
struct Parts {
  int count = 0;
  std::int32_t index[kRays];

  void add(std::int32_t id) {
    if (id >= 0 && std::find(index, index + count, id) == index + count) index[count++] = id;
  }
};

// Colours of all rays of a tile, as Packed() gives them.
void ColorTile(const Frame& frame, Tile& tile, std::uint32_t* out) {
  const int lanes = static_cast<int>(hn::Lanes(D()));

  // The sky hides what is farther away than it is.
  const Sky& sky = frame.backdrop.sky;
  alignas(64) std::int32_t shown[kRays];
  Parts parts;
  std::int32_t last = -1;
  bool empty = false;
  for (int i = 0; i < kRays; i += lanes) {
    VI id = hn::Load(DI(), tile.id + i);
    const V t = Load(tile.t + i);
    if (sky.limit > 0 && !All(hn::Lt(t, Set(0.4F * sky.limit)))) {
      const V3 d = Set(sky.a) + Set(sky.by) * Set(tile.y[i / kTile]) + Set(sky.bx) * Load(tile.x + i % kTile);
      const V limit = Set(sky.limit);
      const M hidden = hn::Or(hn::Gt(t * hn::Sqrt(d.x * d.x + d.z * d.z), limit), hn::Gt(t * hn::Abs(d.y), limit));
      id = hn::IfThenElse(hn::RebindMask(DI(), hidden), SetI(-1), id);
    }
    hn::Store(id, DI(), shown + i);
    empty = empty || !hn::AllFalse(DI(), hn::Lt(id, hn::Zero(DI())));
    if (hn::AllTrue(DI(), hn::Eq(id, SetI(last)))) continue;
    for (int lane = 0; lane < lanes; ++lane) {
      if (shown[i + lane] != last) parts.add(last = shown[i + lane]);
    }
  }

  Normals normals;
  for (int k = 0; k < parts.count && frame.solids.meshes(); ++k) {
    const Aspect& aspect = frame.camera.aspects[parts.index[k]];
    if (frame.solids[aspect.solid].kind != Form::kMesh) continue;
    FindNormals(frame, aspect, parts.index[k], {&tile, tile.t, shown, tile.face}, WindowOf(aspect, tile), normals,
                tile.away);
  }

  Shade shades[kMaxLights];
  if (tile.nearest <= tile.farthest) {
    LookForShadows(frame, tile, nullptr, shades);
    CastShadows(frame, tile, shades);
  }

  Canvas canvas;
  if (empty) {
    std::fill_n(canvas.r, kRays, 0.0F);
    std::fill_n(canvas.g, kRays, 0.0F);
    std::fill_n(canvas.b, kRays, 0.0F);
  }
  if (parts.count > 0) {
    for (int k = 0; k < parts.count; ++k) {
      const int index = parts.index[k];
      const Window w = WindowOf(frame.camera.aspects[index], tile);
      Paint<Brush::kPut>({&frame, &frame.camera, index, &tile, tile.t, shown, tile.face, shades, &normals, 1.0F}, w,
                         canvas);
    }
    if (frame.backdrop.fog.shown) PaintFog(frame.backdrop.fog, tile, shown, canvas);
    if (frame.mirror.solid >= 0) PaintMirror(frame, tile, shown, canvas);
  }
  if (empty && sky.texture != nullptr) PaintSky(frame.backdrop, frame.texels, tile, shown, canvas);
  if (frame.backdrop.haze.shown) PaintHaze(frame.backdrop, tile, canvas);
  if (frame.camera.transparent_count > 0) PaintTransparent(frame, tile, canvas);

  for (int i = 0; i < kRays; i += lanes) {
    const V3 color = AtMostWhite({Load(canvas.r + i), Load(canvas.g + i), Load(canvas.b + i)});
    hn::Store(Packed(color), DI(), reinterpret_cast<std::int32_t*>(out) + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
