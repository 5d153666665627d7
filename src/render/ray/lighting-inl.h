// The light on a solid, and its texture there.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RENDER_RAY_LIGHTING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RENDER_RAY_LIGHTING_INL_H
#undef MIMO_RENDER_RAY_LIGHTING_INL_H
#else
#define MIMO_RENDER_RAY_LIGHTING_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "render/ray/lanes-inl.h"
#include "render/ray/sampling-inl.h"
#include "render/ray/scene.h"
#include "render/ray/shadows-inl.h"
#include "render/ray/tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::render::ray {
namespace HWY_NAMESPACE {

// The part of v along the normal n.
template <Kind kKind>
HWY_INLINE V Along(const V3& n, const V3& v) {
  return kKind == Kind::kPlane ? v.z : Dot(n, v);
}

// The colours of a tile's rays.
struct Canvas {
  alignas(64) float r[kRays];
  float g[kRays];
  float b[kRays];
};

enum class Brush { kPut, kAdd, kBlend };

// What is painted: the rays of a tile that met the solid which aspect `index` shows.
struct Subject {
  const Scene* scene;
  const Eye* eye;
  int index;
  const Tile* tile;
  const float* t;
  const std::int32_t* id;
  const Shade* shades;  // one a caster; null where no shadows are wanted
  float dim;            // what the colour is multiplied by
  float sharp = 0;      // of a textured plane: up to this t no pixel spans more than a texel
};

// The normal of a solid at a point of its surface, in its frame.
template <Kind kKind>
HWY_INLINE V3 Normal(const Solid& solid, const V3& p) {
  const V one = Set(1.0F);
  switch (kKind) {
    case Kind::kPlane: return {Zero(), Zero(), one};
    case Kind::kSphere: return p * Set(1 / solid.size[0]);
    case Kind::kCapsule: {
      const V length = Set(solid.size[1]);
      const V z = hn::Min(hn::Max(p.z, Zero() - length), length);
      return V3{p.x, p.y, p.z - z} * Set(1 / solid.size[0]);
    }
    case Kind::kEllipsoid: {
      const V3 n = {p.x * Set(1 / (solid.size[0] * solid.size[0])), p.y * Set(1 / (solid.size[1] * solid.size[1])),
                    p.z * Set(1 / (solid.size[2] * solid.size[2]))};
      return n * Rsqrt(Dot(n, n));
    }
    case Kind::kCylinder: {
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

// The light that falls on a solid, scattered and mirrored towards the eye: its colour without the texture. A light
// with shadows is added after what all others give is cut at white, and cut by itself, as OpenGL does, which draws
// it in a pass of its own.
template <Kind kKind, bool kGray>
HWY_INLINE V3 Lit(const Subject& subject, const Aspect& aspect, const V3& ray, const V3& p, const V3& n, int i) {
  const Scene& scene = *subject.scene;
  const Material& material = scene.solids[aspect.solid].material;
  const V one = Set(1.0F);
  const bool shiny = material.specular > 0;
  V3 to_eye = ray;
  if (shiny) to_eye = ray * (Zero() - Rsqrt(Dot(ray, ray)));
  const V along_eye = Along<kKind>(n, to_eye);

  const V dim = Set(subject.dim);
  const V3 rgb = Set(material.rgb) * dim;
  // Light that falls in: what the colour scatters and what it mirrors (y and z only where light is coloured).
  V3 diffuse = {Set(scene.ambient), Set(scene.ambient), Set(scene.ambient)};
  V3 mirrored = {Zero(), Zero(), Zero()};
  V3 extra = {Zero(), Zero(), Zero()};  // of lights with shadows
  for (int k = 0; k < scene.light_count; ++k) {
    const Light& light = scene.lights[k];
    const LocalLight& place = scene.local[static_cast<std::size_t>(aspect.solid) * kMaxLights + k];
    const bool separate = subject.shades != nullptr && light.caster >= 0;
    V lit = one;
    if (separate) {
      lit = Load(subject.shades[light.caster].lit + i);
      if (All(hn::Eq(lit, Zero()))) continue;
    }
    V3 to_light = Set(place.position);
    V strength = one;
    if (!light.directional) {
      to_light = to_light - p;
      const V square = Dot(to_light, to_light);
      const V over = Rsqrt(square);
      to_light = to_light * over;
      if (light.attenuated) {
        const V length = square * over;
        strength =
            one / (Set(light.attenuation[0]) + Set(light.attenuation[1]) * length + Set(light.attenuation[2]) * square);
      }
      if (light.spot) {
        const V cosine = Zero() - Dot(to_light, Set(place.direction));
        const M inside = hn::Ge(cosine, Set(light.cos_cutoff));
        if (None(inside)) continue;
        strength = hn::IfThenElseZero(inside, strength * Pow(light.exponent, hn::Max(cosine, Zero())));
      }
    }
    const V along_light = Along<kKind>(n, to_light);
    const V facing = hn::Max(along_light, Zero());
    V glint = Zero();
    if (shiny && light.bright) {
      // Between the normal and the vector half-way between light and eye, whose square is 2 + 2 light . eye.
      const V square = Set(2.0F) + Dot(to_light, to_eye) * Set(2.0F);
      const V cosine = hn::Max(along_light + along_eye, Zero()) * Rsqrt(hn::Max(square, Set(1e-6F)));
      glint = hn::IfThenElseZero(hn::Gt(facing, Zero()), Pow(material.shininess, hn::Min(cosine, one)));
      glint = glint * Set(material.specular);
    }
    // It does not reach faces that look away from it either, not even with its ambient part.
    if (separate) {
      const V on = hn::IfThenElseZero(hn::Gt(facing, Zero()), lit);
      if (kGray) {
        const V d = strength * (Set(light.ambient[0]) + facing * Set(light.diffuse[0]));
        const V s = strength * glint * Set(light.specular[0]);
        extra.x = extra.x + on * hn::Min(rgb.x * d + s, one);
        extra.y = extra.y + on * hn::Min(rgb.y * d + s, one);
        extra.z = extra.z + on * hn::Min(rgb.z * d + s, one);
      } else {
        const V3 d = (Set(light.ambient) + Set(light.diffuse) * facing) * strength;
        const V3 s = Set(light.specular) * (glint * strength);
        extra.x = extra.x + on * hn::Min(rgb.x * d.x + s.x, one);
        extra.y = extra.y + on * hn::Min(rgb.y * d.y + s.y, one);
        extra.z = extra.z + on * hn::Min(rgb.z * d.z + s.z, one);
      }
    } else if (kGray) {
      diffuse.x = diffuse.x + strength * (Set(light.ambient[0]) + facing * Set(light.diffuse[0]));
      mirrored.x = mirrored.x + strength * glint * Set(light.specular[0]);
    } else {
      diffuse = diffuse + (Set(light.ambient) + Set(light.diffuse) * facing) * strength;
      mirrored = mirrored + Set(light.specular) * (glint * strength);
    }
  }
  V3 color;
  if (kGray) {
    color = rgb * diffuse.x + V3{mirrored.x, mirrored.x, mirrored.x};
  } else {
    color = {rgb.x * diffuse.x + mirrored.x, rgb.y * diffuse.y + mirrored.y, rgb.z * diffuse.z + mirrored.z};
  }
  color = color + Set(material.emission) * dim;
  return {hn::Min(color.x, one) + extra.x, hn::Min(color.y, one) + extra.y, hn::Min(color.z, one) + extra.z};
}

// The colour of a solid's texture.
template <Kind kKind>
HWY_INLINE V3 Textured(const Subject& subject, const Aspect& aspect, const V3& ray, const V3& p, const V3& n, V t) {
  const Scene& scene = *subject.scene;
  const Material& material = scene.solids[aspect.solid].material;
  const Texture& texture = *material.texture;
  V u = Zero();
  V v = Zero();
  if (material.mapping == Mapping::kFlat) {
    u = p.x * Set(material.scale[0]) - Set(0.5F);
    v = p.y * Set(material.scale[1]) - Set(0.5F);
    u = u - hn::Floor(u);
    v = v - hn::Floor(v);
    // On a plane, a pixel is stretched by t |ray|^2 / height at most: near parts need not ask further.
    if (kKind == Kind::kPlane && All(hn::Lt(t, Set(subject.sharp)))) {
      return SampleLarge<false>(scene.texels, texture, hn::Zero(DI()), u, v);
    }
  }
  const V3 bx = Set(aspect.bx);
  const V3 by = Set(aspect.by);
  // How the point moves on its tangent plane from pixel to pixel. (Of a plane, t says how far away it is across.)
  const V over = kKind == Kind::kPlane ? t * Set(-1 / aspect.o[2]) : Set(1.0F) / Along<kKind>(n, ray);
  const V3 along_x = (bx - ray * (Along<kKind>(n, bx) * over)) * (t * Set(subject.tile->dx));
  const V3 along_y = (by - ray * (Along<kKind>(n, by) * over)) * (t * Set(subject.tile->dy));
  if (material.mapping == Mapping::kFlat) {
    const V wide = Set(material.scale[0] * static_cast<float>(texture.width));
    const V high = Set(material.scale[1] * static_cast<float>(texture.height));
    const V spread_x = (along_x.x * wide) * (along_x.x * wide) + (along_x.y * high) * (along_x.y * high);
    const V spread_y = (along_y.x * wide) * (along_y.x * wide) + (along_y.y * high) * (along_y.y * high);
    return Sample<false>(scene.texels, texture, hn::Zero(DI()), u, v, hn::Max(spread_x, spread_y));
  }
  const V fold = Set(material.fold);
  const V z = hn::Min(hn::Max(p.z, Zero() - fold), fold);
  const V3 scale = {Set(material.scale[0]), Set(material.scale[1]), Set(material.scale[2])};
  const V3 q = {p.x * scale.x, p.y * scale.y, z * scale.z + (p.z - z) * Set(material.scale[3])};
  const V3 gx = {along_x.x * scale.x, along_x.y * scale.y, along_x.z * scale.z};
  const V3 gy = {along_y.x * scale.x, along_y.y * scale.y, along_y.z * scale.z};
  return SampleCube(scene.texels, texture, q, hn::Max(Dot(gx, gx), Dot(gy, gy)));
}

// On a plane at height h, neighbouring rays meet at most t |ray|^2 / h * t * dx apart.
HWY_INLINE float SharpUpTo(const Subject& subject, const Aspect& aspect) {
  const Tile& tile = *subject.tile;
  const Material& material = subject.scene->solids[aspect.solid].material;
  if (material.mapping != Mapping::kFlat) return 0;
  const float x = std::max(std::abs(tile.x[0]), std::abs(tile.x[kTile - 1]));
  const float y = std::max(std::abs(tile.y[0]), std::abs(tile.y[kTile - 1]));
  const float texels = std::max(std::abs(material.scale[0]) * static_cast<float>(material.texture->width),
                                std::abs(material.scale[1]) * static_cast<float>(material.texture->height));
  return std::sqrt(0.99F * std::abs(aspect.o[2]) / ((1 + x * x + y * y) * tile.dx * texels));
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::render::ray
HWY_AFTER_NAMESPACE();

#endif
