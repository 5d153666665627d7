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

#include "rays/backdrop-inl.h"
#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/planes-inl.h"
#include "rays/shadows-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

constexpr int kNone = -1;
constexpr int kSeveral = -2;
constexpr float kHair = 1e-4F;  // by which all is decided as it would be for each ray

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

// A number that is linear in the slopes, at the corners of a tile.
struct Corners {
  float value[4];

  Corners(const Tile& tile, float a, float bx, float by) {
    for (int k = 0; k < 4; ++k) value[k] = a + by * tile.y[k & 2 ? kTile - 1 : 0] + bx * tile.x[k & 1 ? kTile - 1 : 0];
  }
  float least() const { return *std::min_element(value, value + 4); }
  float most() const { return *std::max_element(value, value + 4); }
};

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

// One face of a cube texture, seen by all rays of a tile: its number, and the components of their directions.
struct Face {
  int number;
  int major, across, down;
  float major_sign, across_sign, down_sign;
};

// The face of the sky's cube on which all of a tile lies; false if it lies on several.
inline bool FindFace(const Corners (&direction)[3], Face& face) {
  const auto is_major = [&](int k) {
    const float least = std::min(std::abs(direction[k].least()), std::abs(direction[k].most()));
    if (direction[k].least() <= 0 && direction[k].most() >= 0) return false;
    return std::all_of(direction, direction + 3, [&](const Corners& other) {
      return &other == &direction[k] || std::max(-other.least(), other.most()) * (1 + kHair) < least;
    });
  };
  for (int k = 0; k < 3; ++k) {
    if (!is_major(k)) continue;
    const float sign = direction[k].least() > 0 ? 1.0F : -1.0F;
    const int number = 2 * k + (sign < 0 ? 1 : 0);
    if (k == 0) face = {number, 0, 2, 1, sign, -sign, -1};
    if (k == 1) face = {number, 1, 0, 2, sign, 1, sign};
    if (k == 2) face = {number, 2, 0, 1, sign, sign, -1};
    return true;
  }
  return false;
}

HWY_NOINLINE void PaintFace(const Sky& sky, const Face& face, const std::uint32_t* texels, const Tile& tile,
                            std::uint32_t* out) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const Mipmap mipmap = MipmapOf<true>(*sky.texture, 0, SetI(face.number));
  const V half = Set(0.5F);
  TapStore taps;
  for (int row = 0; row < kTile; ++row) {
    taps.stride[row] = sky.texture->width + 2;
    for (int column = 0; column < kTile; column += lanes) {
      const V x = Load(tile.x + column);
      const auto along = [&](int k, float sign) {
        return Set(sign * (sky.a[k] + sky.by[k] * tile.y[row])) + Set(sign * sky.bx[k]) * x;
      };
      const V scale = half / along(face.major, face.major_sign);
      const V s = along(face.across, face.across_sign) * scale + half;
      const V t = along(face.down, face.down_sign) * scale + half;
      taps.put(Aim(mipmap, s, t), row * kTile + column);
    }
  }
  for (int i = 0; i < kRays; i += lanes) {
    hn::Store(Packed(Unpacked(taps.fetch(texels, i))), DI(), reinterpret_cast<std::int32_t*>(out) + i);
  }
}

// Colours a tile that shows nothing but one face of the sky, whose texels are no smaller than its pixels.
inline bool ColorSky(const Backdrop& backdrop, const std::uint32_t* texels, const Tile& tile, std::uint32_t* out) {
  const Sky& sky = backdrop.sky;
  if (sky.texture == nullptr || backdrop.fog.shown) return false;
  const Haze& haze = backdrop.haze;
  if (haze.shown && Corners(tile, haze.a[2], haze.bx[2], haze.by[2]).least() < kHair) return false;
  const Corners direction[3] = {Corners(tile, sky.a[0], sky.bx[0], sky.by[0]),
                                Corners(tile, sky.a[1], sky.bx[1], sky.by[1]),
                                Corners(tile, sky.a[2], sky.bx[2], sky.by[2])};
  Face face;
  if (!FindFace(direction, face)) return false;
  const Corners& major = direction[face.major];
  const float width = static_cast<float>(sky.texture->width);
  const float spread = tile.dx * 0.5F * width / std::min(std::abs(major.least()), std::abs(major.most()));
  if (!(spread < 1 - kHair)) return false;
  PaintFace(sky, face, texels, tile, out);
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
