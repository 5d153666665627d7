// What is behind everything, and between: sky, haze and fog.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_BACKDROP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_BACKDROP_INL_H
#undef MIMO_RAYS_BACKDROP_INL_H
#else
#define MIMO_RAYS_BACKDROP_INL_H
#endif

#include <cstdint>

#include "rays/backdrop.h"
#include "rays/lanes-inl.h"
#include "rays/lighting-inl.h"
#include "rays/sampling-inl.h"
#include "rays/sky-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

void PaintSky(const Backdrop& backdrop, const std::uint32_t* texels, const Tile& tile, const std::int32_t* id,
              Canvas& canvas) {
  const Sky& sky = backdrop.sky;
  if (!backdrop.fog.shown && PaintSkyFace(sky, texels, tile, id, canvas)) return;
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 bx = Set(sky.bx);
  const V3 by = Set(sky.by);
  // The sky's map is turned but not scaled: from pixel to pixel, its direction changes as the ray does.
  const V stretch = Set(tile.dx * tile.dx * sky.step * sky.step);
  for (int i = 0; i < kRays; i += lanes) {
    const M empty = hn::RebindMask(D(), hn::Lt(hn::Load(DI(), id + i), hn::Zero(DI())));
    if (None(empty)) continue;
    const V3 d = Set(sky.a) + by * Set(tile.y[i / kTile]) + bx * Load(tile.x + i % kTile);
    V3 color = SampleCube(texels, *sky.texture, d, stretch);
    if (backdrop.fog.shown) {
      // The sky is a cylinder as high as wide.
      const V across = hn::Max(hn::Sqrt(d.x * d.x + d.z * d.z), hn::Abs(d.y));
      color = Fogged(backdrop.fog, color, Set(sky.limit) / hn::Max(across, Set(1e-20F)));
    }
    Store(Pick(empty, color.x, Load(canvas.r + i)), canvas.r + i);
    Store(Pick(empty, color.y, Load(canvas.g + i)), canvas.g + i);
    Store(Pick(empty, color.z, Load(canvas.b + i)), canvas.b + i);
  }
}

// The haze is a cone that rises from the ground at distance (1 - r) of the sky's to the height of the eye at the sky;
// its density grows linearly up to `turn` and falls again.
void PaintHaze(const Backdrop& backdrop, const Tile& tile, Canvas& canvas) {
  const Haze& haze = backdrop.haze;
  const float limit = backdrop.sky.limit;
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 a = Set(haze.a);
  const V3 bx = Set(haze.bx);
  const V3 by = Set(haze.by);
  const V one = Set(1.0F);
  const V e = Set(haze.elevation / haze.radius);
  const V turn = Set(haze.turn);
  for (int i = 0; i < kRays; i += lanes) {
    const V t = Load(tile.t + i);
    if (All(hn::Lt(t, Set(0.3F * limit)))) continue;
    const V3 ray = a + by * Set(tile.y[i / kTile]) + bx * Load(tile.x + i % kTile);
    const V3 ahead = tile.parallel ? a : ray;
    const M down = tile.parallel ? hn::Eq(one, one) : hn::Lt(ray.z, Zero());
    if (None(down)) continue;
    const V level = hn::Sqrt(ahead.x * ahead.x + ahead.y * ahead.y);
    const V drop = (Zero() - ahead.z) / hn::Max(level, Set(1e-20F));
    const V start = tile.parallel ? e + ray.z - a.z : e;  // above the ground, by how fast the cone rises
    const V distance = start / hn::Max(e + drop, Set(1e-20F));
    const V height = one - (one - distance) * Set(1 / haze.radius);
    V alpha = hn::Min(height / turn, (one - height) / (one - turn));
    const M here = hn::And(hn::And(down, hn::Gt(alpha, Zero())), hn::Gt(t * level, distance * Set(limit)));
    if (None(here)) continue;
    alpha = hn::IfThenElseZero(here, hn::Min(alpha, one));
    const V rest = one - alpha;
    V3 color = Set(haze.rgb);
    if (backdrop.fog.shown) color = Fogged(backdrop.fog, color, distance * Set(limit) / hn::Max(level, Set(1e-20F)));
    Store(Load(canvas.r + i) * rest + color.x * alpha, canvas.r + i);
    Store(Load(canvas.g + i) * rest + color.y * alpha, canvas.g + i);
    Store(Load(canvas.b + i) * rest + color.z * alpha, canvas.b + i);
  }
}

// Fog before what the tile shows; what is added or blended later brings its own.
void PaintFog(const Fog& fog, const Tile& tile, const std::int32_t* id, Canvas& canvas) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int i = 0; i < kRays; i += lanes) {
    const M solid = hn::RebindMask(D(), hn::Gt(hn::Load(DI(), id + i), SetI(-1)));
    const V3 old = {Load(canvas.r + i), Load(canvas.g + i), Load(canvas.b + i)};
    const V3 color = Pick(solid, Fogged(fog, old, Load(tile.t + i)), old);
    Store(color.x, canvas.r + i);
    Store(color.y, canvas.g + i);
    Store(color.z, canvas.b + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
