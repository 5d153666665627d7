// Tiles that show nothing but a plane, or nothing but sky: nothing has to be cast there.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_PLAIN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_PLAIN_INL_H
#undef MIMO_RAYS_PLAIN_INL_H
#else
#define MIMO_RAYS_PLAIN_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/planes-inl.h"
#include "rays/shadows-inl.h"
#include "rays/sky-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

constexpr int kNone = -1;
constexpr int kSeveral = -2;

// The one aspect that a tile may show.
inline int OnlyAspect(const Camera& camera, const Tile& tile) {
  int only = kNone;
  for (int i = 0; i < tile.row->count; ++i) {
    const int k = (*tile.row)[i];
    if (IsEmpty(WindowOf(camera.aspects[k], tile))) continue;
    if (only != kNone) return kSeveral;
    only = k;
  }
  return only;
}

// How far away a plane is in a tile; false if not all rays meet it before the sky, its haze, or too near.
inline bool FindDepths(const Frame& frame, const Aspect& aspect, Tile& tile) {
  const Corners nearing(tile, aspect.a[2], aspect.bx[2], aspect.by[2]);
  const float least = aspect.o[2] > 0 ? -nearing.most() : nearing.least();
  const float most = aspect.o[2] > 0 ? -nearing.least() : nearing.most();
  const float height = std::abs(aspect.o[2]);
  if (!(least > 0 && height > 0)) return false;
  tile.nearest = height / most;
  tile.farthest = height / least;
  const float end = frame.backdrop.sky.limit > 0 ? 0.3F * frame.backdrop.sky.limit : 0.5F * kMiss;
  return tile.nearest > frame.camera.near_plane * (1 + kHair) && tile.farthest < end * (1 - kHair);
}

// Whether a plane with edges reaches beyond all corners of a tile.
inline bool Covers(const Solid& solid, const Aspect& aspect, const Tile& tile) {
  const auto slope = [](const float* v, float step, bool last) {
    return last ? v[kTile - 1] + 0.02F * step : v[0] - 0.02F * step;
  };
  for (int i = 0; i < 4; ++i) {
    const float x = slope(tile.x, tile.dx, (i & 1) != 0);
    const float y = slope(tile.y, tile.dy, (i & 2) != 0);
    const float t = -aspect.o[2] / (aspect.a[2] + aspect.by[2] * y + aspect.bx[2] * x);
    if (!(t > 0)) return false;
    for (int k = 0; k < 2; ++k) {
      const float at = aspect.o[k] + (aspect.a[k] + aspect.by[k] * y + aspect.bx[k] * x) * t;
      if (solid.size[k] > 0 && !(std::abs(at) < solid.size[k] * (1 - kHair))) return false;
    }
  }
  return true;
}

// Whether an eye may see anything in a tile.
inline bool SeesAnything(const Eye& eye, const Tile& tile) {
  return std::any_of(eye.aspects.begin(), eye.aspects.begin() + eye.count,
                     [&tile](const Aspect& aspect) { return !IsEmpty(WindowOf(aspect, tile)); });
}

// Colours a tile that shows nothing but one plane, if that is smooth there.
inline bool ColorPlane(const Frame& frame, int index, Tile& tile, std::uint32_t* out) {
  const Aspect& aspect = frame.camera.aspects[index];
  const Solid& solid = frame.solids[aspect.solid];
  if (solid.kind != Form::kPlane || solid.transparent || frame.backdrop.fog.shown || tile.parallel) return false;
  if (!FindDepths(frame, aspect, tile) || !Covers(solid, aspect, tile)) return false;
  if (frame.mirror.solid == aspect.solid && SeesAnything(frame.mirror.eye, tile)) return false;
  Shade shades[kMaxLights];
  const Subject subject = {&frame, &frame.camera, index, &tile, tile.t, tile.id, tile.face, shades, nullptr, 1.0F};
  Smooth own;
  const Smooth* smooth = SmoothAcross(subject, own);
  if (smooth == nullptr) return false;
  const FlatTile flat = {tile, aspect};
  LookForShadows(frame, tile, &flat, shades);
  if (AnyInPart(frame.lights, shades)) {
    StartTile(frame.solids, tile);
    Meet(frame.solids, frame.camera, index, tile);
    CastShadows(frame, tile, shades);
  }
  PaintSmooth(subject, *smooth, out);
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
