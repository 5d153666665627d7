// The light on a solid, and its texture there.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_LIGHTING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_LIGHTING_INL_H
#undef MIMO_RAYS_LIGHTING_INL_H
#else
#define MIMO_RAYS_LIGHTING_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "rays/canvas-inl.h"
#include "rays/frame.h"
#include "rays/lanes-inl.h"
#include "rays/mesh-inl.h"
#include "rays/normals-inl.h"
#include "rays/sampling-inl.h"
#include "rays/shadows-inl.h"
#include "rays/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// The part of v along the normal n.
template <Form kKind>
HWY_INLINE V Along(const V3& n, const V3& v) {
  return kKind == Form::kPlane ? v.z : Dot(n, v);
}

// A colour behind so much fog.
HWY_INLINE V3 Fogged(const Fog& fog, const V3& color, V depth) {
  const V part = (depth - Set(fog.start)) * Set(fog.scale);
  const V f = hn::Min(hn::Max(part, Zero()), Set(1.0F));
  return color * (Set(1.0F) - f) + Set(fog.rgb) * f;
}

// What is painted: the rays of a tile that met the solid which aspect `index` shows.
struct Subject {
  const Frame* frame;
  const Eye* eye;
  int index;
  const Tile* tile;
  const float* t;
  const std::int32_t* id;
  const std::int32_t* face;  // triangles of meshes
  const Shade* shades;       // one a caster; null where no shadows are wanted
  const Normals* normals;    // of meshes
  float dim;                 // what the colour is multiplied by
  float sharp = 0;           // of a textured plane: up to this t no pixel spans more than a texel
};

HWY_INLINE const Material& MaterialOf(const Subject& subject) {
  return subject.frame->solids[subject.eye->aspects[subject.index].solid].material;
}

// The rays that met what is painted.
HWY_INLINE M Mine(const Subject& subject, int i) {
  return hn::RebindMask(D(), hn::Eq(hn::Load(DI(), subject.id + i), SetI(subject.index)));
}

// The triangles that they met. Other rays may have met larger meshes, in whose tables there is more: they get the
// first.
HWY_INLINE VI FaceAt(const Subject& subject, int i) {
  return hn::IfThenElseZero(hn::RebindMask(DI(), Mine(subject, i)), hn::Load(DI(), subject.face + i));
}

// The normal of a solid at a point of its surface, in its frame.
template <Form kKind>
HWY_INLINE V3 Normal(const Solid& solid, const V3& p) {
  const V one = Set(1.0F);
  switch (kKind) {
    case Form::kPlane: return {Zero(), Zero(), one};
    case Form::kSphere: return p * Set(1 / solid.size[0]);
    case Form::kCapsule: {
      const V length = Set(solid.size[1]);
      const V z = hn::Min(hn::Max(p.z, Zero() - length), length);
      return V3{p.x, p.y, p.z - z} * Set(1 / solid.size[0]);
    }
    case Form::kEllipsoid: {
      const V3 n = {p.x * Set(1 / (solid.size[0] * solid.size[0])), p.y * Set(1 / (solid.size[1] * solid.size[1])),
                    p.z * Set(1 / (solid.size[2] * solid.size[2]))};
      return n * Rsqrt(Dot(n, n));
    }
    case Form::kCylinder: {
      // How far p lies beyond the end, against how far beyond the side.
      const V beyond = hn::Abs(p.z) - Set(solid.size[1]);
      const V aside = (p.x * p.x + p.y * p.y) * Set(0.5F / solid.size[0]) - Set(0.5F * solid.size[0]);
      const V over = Set(1 / solid.size[0]);
      return Pick(hn::Gt(beyond, aside), {Zero(), Zero(), hn::CopySign(one, p.z)}, {p.x * over, p.y * over, Zero()});
    }
    default: {
      const V3 beyond = {hn::Abs(p.x) - Set(solid.size[0]), hn::Abs(p.y) - Set(solid.size[1]),
                         hn::Abs(p.z) - Set(solid.size[2])};
      const M on_x = hn::And(hn::Ge(beyond.x, beyond.y), hn::Ge(beyond.x, beyond.z));
      const M on_y = hn::AndNot(on_x, hn::Ge(beyond.y, beyond.z));
      const M on_z = hn::Not(hn::Or(on_x, on_y));
      return {hn::IfThenElseZero(on_x, hn::CopySign(one, p.x)), hn::IfThenElseZero(on_y, hn::CopySign(one, p.y)),
              hn::IfThenElseZero(on_z, hn::CopySign(one, p.z))};
    }
  }
}

// A point of a solid as light sees it, in the solid's frame.
struct Spot {
  V3 p, n;
  V3 to_eye;    // unit length where the solid is shiny
  V along_eye;  // the part of that along the normal
};

template <Form kKind>
HWY_INLINE Spot SpotAt(const Material& material, const V3& ray, const V3& p, const V3& n) {
  V3 to_eye = ray;
  if (material.specular > 0) to_eye = ray * (Zero() - Rsqrt(Dot(ray, ray)));
  return {p, n, to_eye, Along<kKind>(n, to_eye)};
}

// What one light gives a point, before its colours.
struct Beam {
  V strength;  // after attenuation and within the cone
  V facing;    // cosine of the angle at which it falls in, 0 from behind
  V glint;     // what is mirrored
};

// Whether any point is within the light's cone; where not, there is no beam.
template <Form kKind>
HWY_INLINE bool Shine(const Light& light, const LocalLight& place, const Material& material, const Spot& at,
                      Beam& beam) {
  const V one = Set(1.0F);
  V3 to_light = Set(place.position);
  beam.strength = one;
  if (!light.directional) {
    to_light = to_light - at.p;
    const V square = Dot(to_light, to_light);
    const V over = Rsqrt(square);
    to_light = to_light * over;
    if (light.attenuated) {
      const V length = square * over;
      beam.strength =
          one / (Set(light.attenuation[0]) + Set(light.attenuation[1]) * length + Set(light.attenuation[2]) * square);
    }
    if (light.spot) {
      const V cosine = Zero() - Dot(to_light, Set(place.direction));
      const M inside = hn::Ge(cosine, Set(light.cos_cutoff));
      if (None(inside)) return false;
      beam.strength = hn::IfThenElseZero(inside, beam.strength * Pow(light.exponent, hn::Max(cosine, Zero())));
    }
  }
  const V along_light = Along<kKind>(at.n, to_light);
  beam.facing = hn::Max(along_light, Zero());
  beam.glint = Zero();
  const M faces = hn::Gt(beam.facing, Zero());
  if (material.specular > 0 && light.bright && !None(faces)) {
    // Between the normal and the vector half-way between light and eye, whose square is 2 + 2 light . eye.
    const V square = Set(2.0F) + Dot(to_light, at.to_eye) * Set(2.0F);
    const V cosine = hn::Max(along_light + at.along_eye, Zero()) * Rsqrt(hn::Max(square, Set(1e-6F)));
    beam.glint = hn::IfThenElseZero(faces, Pow(material.shininess, hn::Min(cosine, one)));
    beam.glint = beam.glint * Set(material.specular);
  }
  return true;
}

// Colour that one light gives a solid of colour rgb. Of grey light, only x is looked at.
template <bool kGray>
HWY_INLINE V3 Reflected(const Light& light, const Beam& beam, const V3& rgb) {
  if (kGray) {
    const V d = beam.strength * (Set(light.ambient[0]) + beam.facing * Set(light.diffuse[0]));
    const V s = beam.strength * beam.glint * Set(light.specular[0]);
    return {rgb.x * d + s, rgb.y * d + s, rgb.z * d + s};
  }
  const V3 d = (Set(light.ambient) + Set(light.diffuse) * beam.facing) * beam.strength;
  const V3 s = Set(light.specular) * (beam.glint * beam.strength);
  return {rgb.x * d.x + s.x, rgb.y * d.y + s.y, rgb.z * d.z + s.z};
}

// The light that falls on a solid, scattered and mirrored towards the eye: its colour without the texture. A light
// with shadows is added after what all others give is cut at white, and cut by itself, as OpenGL does, which draws
// it in a pass of its own.
template <Form kKind, bool kGray>
HWY_INLINE V3 Lit(const Subject& subject, const Aspect& aspect, const V3& ray, const V3& p, const V3& n, int i) {
  const Frame& frame = *subject.frame;
  const Material& material = frame.solids[aspect.solid].material;
  const Spot at = SpotAt<kKind>(material, ray, p, n);
  const V dim = Set(subject.dim);
  const V3 rgb = Set(material.rgb) * dim;
  V3 color = rgb * Set(frame.lights.ambient()) + Set(material.emission) * dim;
  V3 extra = {Zero(), Zero(), Zero()};  // of lights with shadows
  for (int k = 0; k < frame.lights.count(); ++k) {
    const Light& light = frame.lights[k];
    const bool separate = subject.shades != nullptr && light.caster >= 0;
    V lit = Set(1.0F);
    if (separate) {
      lit = LitAt(subject.shades[light.caster], i);
      if (All(hn::Eq(lit, Zero()))) continue;
    }
    Beam beam;
    if (!Shine<kKind>(light, frame.lights.at(aspect.solid, k), material, at, beam)) continue;
    const V3 reflected = Reflected<kGray>(light, beam, rgb);
    if (separate) {
      // It does not reach faces that look away from it either, not even with its ambient part.
      const V on = hn::IfThenElseZero(hn::Gt(beam.facing, Zero()), lit);
      extra = extra + AtMostWhite(reflected) * on;
    } else {
      color = color + reflected;
    }
  }
  return AtMostWhite(color) + extra;
}

// Where a flat texture shows at a point, 0..1.
HWY_INLINE V Repeated(V s) { return s - hn::Floor(s); }

// How a point moves on its tangent plane from pixel to pixel.
struct Steps {
  V3 x, y;
};

template <Form kKind>
HWY_INLINE Steps StepsAt(const Subject& subject, const Aspect& aspect, const V3& ray, const V3& n, V t) {
  const V3 bx = Set(aspect.bx);
  const V3 by = Set(aspect.by);
  const bool parallel = subject.tile->parallel;
  // (Of a plane, t says how far away it is across.)
  const V over = kKind == Form::kPlane && !parallel ? t * Set(-1 / aspect.o[2]) : Set(1.0F) / Along<kKind>(n, ray);
  const V spread = parallel ? Set(1.0F) : t;
  return {(bx - ray * (Along<kKind>(n, bx) * over)) * (spread * Set(subject.tile->dx)),
          (by - ray * (Along<kKind>(n, by) * over)) * (spread * Set(subject.tile->dy))};
}

// The square of the texels that a pixel spans, of a flat texture, and of a cube's in texture space.
template <Form kKind>
HWY_INLINE V Spread(const Subject& subject, const Aspect& aspect, const Material& material, const V3& ray, const V3& n,
                    V t, bool cube) {
  const auto [along_x, along_y] = StepsAt<kKind>(subject, aspect, ray, n, t);
  if (!cube) {
    const V wide = Set(material.mapping.scale[0] * static_cast<float>(material.texture->width));
    const V high = Set(material.mapping.scale[1] * static_cast<float>(material.texture->height));
    const V spread_x = (along_x.x * wide) * (along_x.x * wide) + (along_x.y * high) * (along_x.y * high);
    const V spread_y = (along_y.x * wide) * (along_y.x * wide) + (along_y.y * high) * (along_y.y * high);
    return hn::Max(spread_x, spread_y);
  }
  const V3 scale = {Set(material.mapping.scale[0]), Set(material.mapping.scale[1]), Set(material.mapping.scale[2])};
  const V3 gx = {along_x.x * scale.x, along_x.y * scale.y, along_x.z * scale.z};
  const V3 gy = {along_y.x * scale.x, along_y.y * scale.y, along_y.z * scale.z};
  return hn::Max(Dot(gx, gx), Dot(gy, gy));
}

// The colour of a solid's texture.
template <Form kKind>
HWY_INLINE V3 Textured(const Subject& subject, const Aspect& aspect, const V3& ray, const V3& p, const V3& n, V t,
                       int i) {
  const Frame& frame = *subject.frame;
  const Material& material = frame.solids[aspect.solid].material;
  const Texture& texture = *material.texture;
  const bool cube = material.mapping.kind == Mapping::kCube;
  if (kKind == Form::kMesh && material.mapping.kind == Mapping::kGiven) {
    const SurfaceAt<Known::kTexture> surface(*frame.solids[aspect.solid].mesh, FaceAt(subject, i), p);
    const Steps steps = StepsAt<kKind>(subject, aspect, ray, n, t);
    const V wide = Set(static_cast<float>(texture.width));
    const V high = Set(static_cast<float>(texture.height));
    const auto spread = [&](const V3& step) {
      const V x = surface.change(0, step) * wide;
      const V y = surface.change(1, step) * high;
      return x * x + y * y;
    };
    return Unpacked(Filter<false>(frame.texels, texture, hn::Zero(DI()), Repeated(surface.texture(0)),
                                  Repeated(surface.texture(1)), LevelOf(hn::Max(spread(steps.x), spread(steps.y)))));
  }
  if (!cube) {
    const V u = Repeated(p.x * Set(material.mapping.scale[0]) + Set(material.mapping.origin[0]));
    const V v = Repeated(p.y * Set(material.mapping.scale[1]) + Set(material.mapping.origin[1]));
    // On a plane, a pixel is stretched by t |ray|^2 / height at most: near parts need not ask further.
    if (kKind == Form::kPlane && All(hn::Lt(t, Set(subject.sharp)))) {
      return Unpacked(FilterLarge<false>(frame.texels, texture, hn::Zero(DI()), u, v));
    }
    const V spread = Spread<kKind>(subject, aspect, material, ray, n, t, false);
    return Unpacked(Filter<false>(frame.texels, texture, hn::Zero(DI()), u, v, LevelOf(spread)));
  }
  const V fold = Set(material.mapping.fold);
  const V z = hn::Min(hn::Max(p.z, Zero() - fold), fold);
  const V3 q = {p.x * Set(material.mapping.scale[0]), p.y * Set(material.mapping.scale[1]),
                z * Set(material.mapping.scale[2]) + (p.z - z) * Set(material.mapping.scale[3])};
  return SampleCube(frame.texels, texture, q, Spread<kKind>(subject, aspect, material, ray, n, t, true));
}

// On a plane at height h, neighbouring rays meet at most t |ray|^2 / h * t * dx apart.
HWY_INLINE float SharpUpTo(const Subject& subject, const Aspect& aspect) {
  const Tile& tile = *subject.tile;
  const Material& material = subject.frame->solids[aspect.solid].material;
  if (material.mapping.kind != Mapping::kFlat || tile.parallel) return 0;
  const float x = std::max(std::abs(tile.x[0]), std::abs(tile.x[kTile - 1]));
  const float y = std::max(std::abs(tile.y[0]), std::abs(tile.y[kTile - 1]));
  const float texels = std::max(std::abs(material.mapping.scale[0]) * static_cast<float>(material.texture->width),
                                std::abs(material.mapping.scale[1]) * static_cast<float>(material.texture->height));
  return std::sqrt(0.99F * std::abs(aspect.o[2]) / ((1 + x * x + y * y) * tile.dx * texels));
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
