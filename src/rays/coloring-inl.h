// The colours of a tile, layer by layer.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RENDER_RAY_COLORING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RENDER_RAY_COLORING_INL_H
#undef MIMO_RENDER_RAY_COLORING_INL_H
#else
#define MIMO_RENDER_RAY_COLORING_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "render/ray/backdrop-inl.h"
#include "render/ray/lanes-inl.h"
#include "render/ray/painting-inl.h"
#include "render/ray/scene.h"
#include "render/ray/shadows-inl.h"
#include "render/ray/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::render::ray {
namespace HWY_NAMESPACE {

// The mirror's reflections, where the tile shows the mirror.
void PaintMirror(const Scene& scene, const Tile& tile, const std::int32_t* shown, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const int mirror = scene.seen[scene.mirror];
  if (mirror < 0) return;
  const Window all = WindowOf(scene.camera.aspects[mirror], tile);
  if (IsEmpty(all)) return;
  alignas(64) float t[kRays];
  alignas(64) std::int32_t id[kRays];
  alignas(64) std::int32_t face[kRays];
  bool any = false;
  for (int k = 0; k < scene.mirrored.count; ++k) {
    const Window w = WindowOf(scene.mirrored.aspects[k], tile);
    if (IsEmpty(w)) continue;
    if (!any) {
      any = true;
      std::fill_n(t, kRays, kMiss);
      std::fill_n(id, kRays, -1);
      if (scene.meshes) std::fill_n(face, kRays, 0);
    }
    Cast<true>(scene, scene.mirrored, k, tile, w, tile.t, t, id, face);
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
    Paint<Brush::kAdd>({&scene, &scene.mirrored, k, &tile, t, id, face, nullptr, scene.reflectance}, w, canvas);
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
    alignas(64) std::int32_t face[kRays];
    std::copy_n(tile.t, kRays, t);
    std::fill_n(id, kRays, -1);
    if (scene.meshes) std::fill_n(face, kRays, 0);
    Cast<false>(scene, scene.camera, index, tile, w, &scene.near_plane, t, id, face);
    Paint<Brush::kBlend>({&scene, &scene.camera, index, &tile, t, id, face, nullptr, 1.0F}, w, canvas);
  }
}

// Colours of all rays of a tile: bytes red, green, blue, and one that does not count.
void ColorTile(const Scene& scene, const Tile& tile, std::uint32_t* out) {
  const int lanes = static_cast<int>(hn::Lanes(D()));

  Shade shades[kMaxLights];
  for (int k = 0; k < scene.caster_count && tile.nearest <= tile.farthest; ++k) {
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
      const V3 d =
          Set(scene.sky_a) + Set(scene.sky_by) * Set(tile.y[i / kTile]) + Set(scene.sky_bx) * Load(tile.x + i % kTile);
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
      Paint<Brush::kPut>({&scene, &scene.camera, k, &tile, tile.t, shown, tile.face, shades, 1.0F}, w, canvas);
    }
    if (scene.fog) PaintFog(scene, tile, shown, canvas);
    if (scene.mirror >= 0) PaintMirror(scene, tile, shown, canvas);
  }
  if (empty && scene.sky != nullptr) PaintSky(scene, tile, shown, canvas);
  if (scene.haze) PaintHaze(scene, tile, canvas);
  if (scene.transparent_count > 0) PaintTransparent(scene, tile, canvas);

  const V one = Set(1.0F);
  const V scale = Set(255.0F);
  for (int i = 0; i < kRays; i += lanes) {
    const VI r = Low16(hn::Min(Load(canvas.r + i), one) * scale);
    const VI g = Low16(hn::Min(Load(canvas.g + i), one) * scale);
    const VI b = Low16(hn::Min(Load(canvas.b + i), one) * scale);
    hn::Store(hn::Or(r, hn::Or(hn::ShiftLeft<8>(g), hn::ShiftLeft<16>(b))), DI(),
              reinterpret_cast<std::int32_t*>(out) + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::render::ray
HWY_AFTER_NAMESPACE();

#endif
