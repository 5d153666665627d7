// Tiles that show nothing but an endless plane, or nothing but sky: nothing has to be cast there.
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
  for (int k = 0; k < camera.count; ++k) {
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

// Colours a tile that shows nothing but one plane, if that is smooth there.
inline bool ColorPlane(const Frame& frame, int index, Tile& tile, std::uint32_t* out) {
  const Aspect& aspect = frame.camera.aspects[index];
  const Solid& solid = frame.solids[aspect.solid];
  if (solid.kind != Form::kPlane || solid.size[0] > 0 || solid.size[1] > 0 || solid.transparent) return false;
  if (frame.backdrop.fog.shown || frame.mirror.solid == aspect.solid) return false;
  if (!FindDepths(frame, aspect, tile)) return false;
  Shade shades[kMaxLights];
  const Subject subject = {&frame, &frame.camera, index, &tile, tile.t, tile.id, tile.face, shades, 1.0F};
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
