// What changes little across a patch of a plane: computed at a few rays only, interpolated between them.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_SMOOTH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_SMOOTH_INL_H
#undef MIMO_RAYS_SMOOTH_INL_H
#else
#define MIMO_RAYS_SMOOTH_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/lighting-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// What is probed: a tile, or several side by side.
struct Patch {
  float x, y;  // slopes of its first ray
  int width;   // rays in a row of it
};

// Where a patch is probed, from -1 to 1 between its first and last column or row: three times three points that a
// quadratic goes through, and others where it must hold. The first four are the corners.
constexpr int kProbes = 16;
alignas(64) constexpr float kProbeX[kProbes] = {-1, 1, -1, 1, 0, 0, -1, 1, 0, -.5F, .5F, -.5F, .5F, 0, 0, .5F};
alignas(64) constexpr float kProbeY[kProbes] = {-1, -1, 1, 1, -1, 1, 0, 0, 0, -.5F, -.5F, .5F, .5F, -.5F, .5F, 0};
constexpr int kNodes = 9;

// A number that is a quadratic along rows and columns: of each row, the coefficients of 1, x and x^2.
struct Sheet {
  alignas(64) float c[3][kTile];
  float most;  // more than it is anywhere
};

HWY_INLINE V AcrossPatch(int first, int width) {
  return hn::Iota(D(), static_cast<float>(first)) * Set(2.0F / static_cast<float>(width - 1)) - Set(1.0F);
}

HWY_INLINE V At(const Sheet& sheet, int row, V x) {
  return (Set(sheet.c[2][row]) * x + Set(sheet.c[1][row])) * x + Set(sheet.c[0][row]);
}

// The quadratic through the nodes; false if it misses another probe by more than `tolerance`.
inline bool Stretch(const float* f, float tolerance, Sheet& sheet) {
  // Along rows first: coefficients at the upper, the middle and the lower row.
  const float low[3] = {f[4], 0.5F * (f[1] - f[0]), 0.5F * (f[1] + f[0]) - f[4]};
  const float middle[3] = {f[8], 0.5F * (f[7] - f[6]), 0.5F * (f[7] + f[6]) - f[8]};
  const float high[3] = {f[5], 0.5F * (f[3] - f[2]), 0.5F * (f[3] + f[2]) - f[5]};
  float d[3][3];
  for (int k = 0; k < 3; ++k) {
    d[k][0] = middle[k];
    d[k][1] = 0.5F * (high[k] - low[k]);
    d[k][2] = 0.5F * (high[k] + low[k]) - middle[k];
  }
  const auto along_y = [&d](int k, V y) { return (Set(d[k][2]) * y + Set(d[k][1])) * y + Set(d[k][0]); };
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int i = kNodes / lanes * lanes; i < kProbes; i += lanes) {
    const V x = Load(kProbeX + i);
    const V y = Load(kProbeY + i);
    const V value = (along_y(2, y) * x + along_y(1, y)) * x + along_y(0, y);
    if (!All(hn::Le(hn::Abs(value - Load(f + i)), Set(tolerance)))) return false;
  }
  for (int row = 0; row < kTile; row += lanes) {
    for (int k = 0; k < 3; ++k) Store(along_y(k, AcrossPatch(row, kTile)), sheet.c[k] + row);
  }
  sheet.most = d[0][0] + 1e-3F;
  for (int k = 1; k < 9; ++k) sheet.most += std::abs(d[k / 3][k % 3]);
  return true;
}

// Tiles side by side have their light in common where all of them are smooth, at most so many.
constexpr int kMostTiles = 4;

// A patch's light on a plane without its shadows and texture, and the level of its texture.
struct Smooth {
  alignas(64) float x[kMostTiles * kTile];  // where its columns are, from -1 to 1
  const float* first;                       // where the columns of the tile are that is painted
  bool gray;                                // all three channels are equal
  Sheet color[3];                           // of all lights without shadows
  Sheet extra[kMaxLights][3];               // of each other light: not set where there is none
  bool reached[kMaxLights];                 // by that light
  Sheet total;  // of all lights where nothing is in shadow; only of grey ones none of which is cut at white
  bool has_total;
  Sheet level;

  HWY_INLINE V across(int column) const { return Load(first + column); }
};

// The probes of a patch on a plane.
struct Probes {
  alignas(64) float dx[kProbes], dy[kProbes], dz[kProbes];  // rays
  float px[kProbes], py[kProbes];                           // points
  float t[kProbes];
  float wide;   // how far apart the points are, at most
  float angle;  // between rays, at most
};

// False where the patch reaches beyond the horizon.
inline bool Probe(const Aspect& aspect, const Tile& tile, const Patch& patch, Probes& probes) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const float half_x = 0.5F * static_cast<float>(patch.width - 1) * tile.dx;
  const float half_y = 0.5F * (kTile - 1) * tile.dy;
  for (int i = 0; i < kProbes; i += lanes) {
    const V x = (Load(kProbeX + i) + Set(1.0F)) * Set(half_x) + Set(patch.x);
    const V y = (Load(kProbeY + i) + Set(1.0F)) * Set(half_y) + Set(patch.y);
    const V3 d = Set(aspect.a) + Set(aspect.by) * y + Set(aspect.bx) * x;
    const V t = Set(-aspect.o[2]) / d.z;
    if (!All(hn::Gt(t, Zero()))) return false;
    Store(d.x, probes.dx + i);
    Store(d.y, probes.dy + i);
    Store(d.z, probes.dz + i);
    Store(Set(aspect.o[0]) + d.x * t, probes.px + i);
    Store(Set(aspect.o[1]) + d.y * t, probes.py + i);
    Store(t, probes.t + i);
  }
  const auto range = [](const float* v) {
    return std::max({v[0], v[1], v[2], v[3]}) - std::min({v[0], v[1], v[2], v[3]});
  };
  probes.angle = 2 * length_of(half_x, half_y);
  probes.wide = length_of(range(probes.px), range(probes.py));
  return true;
}

// Whether a spotlight's cone holds all of the patch: it does if it holds the corners.
inline bool IsWithin(const Light& light, const LocalLight& place, const Probes& probes) {
  const float least = light.cos_cutoff + 1e-5F;
  for (int i = 0; i < 4 && least > 0; ++i) {
    const float to[3] = {place.position[0] - probes.px[i], place.position[1] - probes.py[i], place.position[2]};
    const float along = -(to[0] * place.direction[0] + to[1] * place.direction[1] + to[2] * place.direction[2]);
    const float square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
    if (!(along > 0 && along * along >= least * least * square)) return false;
  }
  return least > 0;
}

// Whether it does not touch the patch, across which the direction to the light turns by so much.
inline bool IsWithout(const Light& light, const LocalLight& place, const Probes& probes, float turn) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int i = 0; i < kProbes; i += lanes) {
    const V3 to = Set(place.position) - V3{Load(probes.px + i), Load(probes.py + i), Zero()};
    const V cosine = (Zero() - Dot(to, Set(place.direction))) * Rsqrt(Dot(to, to));
    if (!All(hn::Lt(cosine, Set(light.cos_cutoff - turn)))) return false;
  }
  return true;
}

// By how much the vector half-way between light and eye turns across the patch: as much as both together, over the
// length of their sum, which is short where light grazes the floor towards the eye.
inline float TurnHalfWay(const Light& light, const LocalLight& place, const Probes& probes, float turn) {
  V least = Set(4.0F);  // the square of that length
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int i = 0; i < kProbes; i += lanes) {
    const V3 ray = {Load(probes.dx + i), Load(probes.dy + i), Load(probes.dz + i)};
    V3 to = Set(place.position);
    if (!light.directional) to = to - V3{Load(probes.px + i), Load(probes.py + i), Zero()};
    const V cosine = (Zero() - Dot(ray, to)) * Rsqrt(Dot(ray, ray)) * Rsqrt(Dot(to, to));
    least = hn::Min(least, Set(2.0F) + Set(2.0F) * cosine);
  }
  return (turn + probes.angle) / std::sqrt(std::max(hn::GetLane(hn::MinOfLanes(D(), least)), 1e-6F));
}

// Whether a light has no edges or peaks that fit between the probes.
inline bool IsGentle(const Light& light, const LocalLight& place, const Material& material, const Probes& probes) {
  float turn = 0;  // of the direction to the light across the patch, at most
  if (!light.directional) {
    float square = place.position[2] * place.position[2];
    const float x = place.position[0] - probes.px[8];
    const float y = place.position[1] - probes.py[8];
    const float aside = std::max(std::sqrt(x * x + y * y) - probes.wide, 0.0F);
    square += aside * aside;
    turn = probes.wide / std::sqrt(square);
    if (!(turn < 0.7F)) return false;
    if (light.spot && !(turn * turn * light.exponent.exponent < 8)) return false;
    if (light.spot && !IsWithin(light, place, probes) && !IsWithout(light, place, probes, turn)) return false;
  }
  if (material.specular > 0 && light.bright) {
    turn = TurnHalfWay(light, place, probes, turn);
    if (!(turn * turn * material.shininess.exponent < 8)) return false;
  }
  return true;
}

// Colour up to white.
template <bool kGray>
HWY_INLINE V3 ColorAt(const Sheet (&sheets)[3], int row, V x) {
  const V one = Set(1.0F);
  const V r = hn::Min(At(sheets[0], row, x), one);
  if (kGray) return {r, r, r};
  return {r, hn::Min(At(sheets[1], row, x), one), hn::Min(At(sheets[2], row, x), one)};
}

inline bool SmoothLight(const Subject& subject, const Aspect& aspect, const Probes& probes, Smooth& smooth) {
  constexpr float kTolerance = 0.25F / 255;
  const Frame& frame = *subject.frame;
  const Material& material = frame.solids[aspect.solid].material;
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const V3 rgb = Set(material.rgb);
  const auto equal = [](const std::array<float, 3>& v) { return v[0] == v[1] && v[1] == v[2]; };
  smooth.gray = frame.lights.gray() && equal(material.rgb) && equal(material.emission);
  const int channels = smooth.gray ? 1 : 3;
  alignas(64) float color[3][kProbes];
  alignas(64) float extra[3][kProbes];
  for (int k = 0; k < 3; ++k)
    std::fill_n(color[k], kProbes, frame.lights.ambient() * material.rgb[k] + material.emission[k]);
  for (int k = 0; k < frame.lights.count(); ++k) {
    const Light& light = frame.lights[k];
    const LocalLight& place = frame.lights.at(aspect.solid, k);
    if (!IsGentle(light, place, material, probes)) return false;
    const bool separate = light.caster >= 0;
    bool reached = false;
    for (int i = 0; i < kProbes; i += lanes) {
      const V3 ray = {Load(probes.dx + i), Load(probes.dy + i), Load(probes.dz + i)};
      const V3 p = {Load(probes.px + i), Load(probes.py + i), Zero()};
      const Spot at = SpotAt<Form::kPlane>(material, ray, p, {Zero(), Zero(), Set(1.0F)});
      Beam beam;
      V3 reflected = {Zero(), Zero(), Zero()};
      if (Shine<Form::kPlane>(light, place, material, at, beam)) {
        reached = reached || !separate || !None(hn::Gt(beam.facing, Zero()));
        reflected = Reflected<false>(light, beam, rgb);
      }
      if (separate) {
        Store(reflected.x, extra[0] + i);
        Store(reflected.y, extra[1] + i);
        Store(reflected.z, extra[2] + i);
      } else {
        Store(Load(color[0] + i) + reflected.x, color[0] + i);
        Store(Load(color[1] + i) + reflected.y, color[1] + i);
        Store(Load(color[2] + i) + reflected.z, color[2] + i);
      }
    }
    if (!separate) continue;
    smooth.reached[light.caster] = reached;
    for (int c = 0; c < channels && reached; ++c) {
      if (!Stretch(extra[c], kTolerance, smooth.extra[light.caster][c])) return false;
    }
  }
  for (int c = 0; c < channels; ++c) {
    if (!Stretch(color[c], kTolerance, smooth.color[c])) return false;
  }
  return true;
}

// Adds up light that no shadow and no cutting at white keeps apart.
inline void AddUp(const Lights& lights, Smooth& smooth) {
  smooth.has_total = smooth.gray && smooth.color[0].most < 1;
  if (!smooth.has_total) return;
  smooth.total = smooth.color[0];
  for (int k = 0; k < lights.caster_count(); ++k) {
    if (!smooth.reached[k]) continue;
    const Sheet& extra = smooth.extra[k][0];
    smooth.has_total = smooth.has_total && extra.most < 1;
    for (int c = 0; c < 3; ++c) {
      for (int row = 0; row < kTile; ++row) smooth.total.c[c][row] += extra.c[c][row];
    }
    smooth.total.most += extra.most;
  }
}

inline bool SmoothLevel(const Subject& subject, const Aspect& aspect, const Probes& probes, Smooth& smooth) {
  const Material& material = subject.frame->solids[aspect.solid].material;
  const int lanes = static_cast<int>(hn::Lanes(D()));
  alignas(64) float level[kProbes];
  for (int i = 0; i < kProbes; i += lanes) {
    const V3 ray = {Load(probes.dx + i), Load(probes.dy + i), Load(probes.dz + i)};
    const V spread =
        Spread<Form::kPlane>(subject, aspect, material, ray, {Zero(), Zero(), Set(1.0F)}, Load(probes.t + i), false);
    Store(Set(0.5F) * Log2(hn::Max(spread, Set(1e-12F))), level + i);
  }
  return Stretch(level, 0.02F, smooth.level);
}

// Whether all that is asked for is smooth on a patch.
inline bool Smoothen(const Subject& subject, const Patch& patch, Smooth& smooth) {
  const Aspect& aspect = subject.eye->aspects[subject.index];
  const Material& material = subject.frame->solids[aspect.solid].material;
  if (material.mapping.kind == Mapping::kCube) return false;
  Probes probes;
  if (!Probe(aspect, *subject.tile, patch, probes) || !SmoothLight(subject, aspect, probes, smooth)) return false;
  if (material.mapping.kind == Mapping::kFlat && !SmoothLevel(subject, aspect, probes, smooth)) return false;
  AddUp(subject.frame->lights, smooth);
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int column = 0; column < patch.width; column += lanes) {
    Store(AcrossPatch(column, patch.width), smooth.x + column);
  }
  return true;
}

// Tiles side by side, and what is smooth across all of them on the plane that was asked for last.
struct Strip {
  Patch patch;
  int index;  // of the plane's aspect, -1 for none
  bool is_smooth;
  Smooth smooth;
  int rough_place, rough_index;  // of the tile and the plane that were found not to be smooth last

  void start(const Patch& next) {
    patch = next;
    index = rough_place = rough_index = -1;
  }
};

// What is smooth on a plane across a tile, from its strip if that is smooth; null if it is not.
inline const Smooth* SmoothAcross(const Subject& subject, Smooth& own) {
  if (subject.tile->parallel) return nullptr;
  Strip& strip = *subject.tile->strip;
  if (strip.index != subject.index) {
    strip.index = subject.index;
    strip.is_smooth = Smoothen(subject, strip.patch, strip.smooth);
  }
  if (strip.is_smooth) {
    strip.smooth.first = strip.smooth.x + subject.tile->place;
    return &strip.smooth;
  }
  const int place = subject.tile->place;
  const bool rough = strip.rough_place == place && strip.rough_index == subject.index;
  if (strip.patch.width == kTile || rough) return nullptr;
  own.first = own.x;
  if (Smoothen(subject, {subject.tile->x[0], subject.tile->y[0], kTile}, own)) return &own;
  strip.rough_place = place;
  strip.rough_index = subject.index;
  return nullptr;
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
