// The eyes of many worlds on a graphics card: one picture a block, 8 x 4 pixels a warp. The pictures are those of
// src/rays for the primitives of MuJoCo, with shadows, sky and haze; without meshes, mirrors, transparent things and
// several samples a pixel. A compiler of C++ makes the same code for the processor (`-x c++`). card.py builds and calls
// both; drawn.py makes the structs below.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#ifdef __CUDACC__
#include <cuda_runtime.h>
#define DEV __device__ __forceinline__
#else
#define DEV static inline
#endif
// Kinds are those of MuJoCo. A mapping of 1 lays a flat texture, of 2 a cube.
struct Solid {
  int kind;
  float size[3];
  float radius;
  float rgb[3];
  float emission[3];
  float specular, exponent;
  int texture, mapping;
  float scale[4], origin[2], fold;
  int geom;
};
struct Texture {
  int width, height, levels, cube, origin[16];
};
struct Light {
  int directional, spot, attenuated, bright, shadow, index;
  float ambient[3], diffuse[3], specular[3], attenuation[3], cutoff, exponent;
};
struct Scene {
  int solids, lights, width, shadows;
  float slope, near_plane, far_plane, sky_limit, haze_radius, haze_turn, haze[3];
  int sky, ground;
};
constexpr int kMost = 64, kLights = 4;
constexpr float kMiss = 1e10f;
struct V {
  float x, y, z;
};
DEV V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
DEV V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
DEV V operator*(V a, float s) { return {a.x * s, a.y * s, a.z * s}; }
DEV float dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
DEV V vec(const float* p) { return {p[0], p[1], p[2]}; }
DEV V column(const float* m, int k) { return {m[k], m[3 + k], m[6 + k]}; }
DEV V local(const float* m, V v) { return {dot(column(m, 0), v), dot(column(m, 1), v), dot(column(m, 2), v)}; }
DEV float least(float a, float b) { return a < b ? a : b; }
DEV float most(float a, float b) { return a > b ? a : b; }
DEV float clampf(float a, float l, float h) { return least(most(a, l), h); }
DEV V white(V c) { return {least(c.x, 1.f), least(c.y, 1.f), least(c.z, 1.f)}; }

DEV float enter(const Solid& s, V o, V d) {
  switch (s.kind) {
    case 0: {
      const float t = -o.z / d.z;
      if (!(t > 0)) return kMiss;
      if (s.size[0] > 0 && !(fabsf(o.x + t * d.x) <= s.size[0])) return kMiss;
      if (s.size[1] > 0 && !(fabsf(o.y + t * d.y) <= s.size[1])) return kMiss;
      return t;
    }
    case 2:
    case 4: {
      float r2 = s.size[0] * s.size[0];
      if (s.kind == 4) {
        o = {o.x / s.size[0], o.y / s.size[1], o.z / s.size[2]};
        d = {d.x / s.size[0], d.y / s.size[1], d.z / s.size[2]};
        r2 = 1;
      }
      const V k = {o.y * d.z - o.z * d.y, o.z * d.x - o.x * d.z, o.x * d.y - o.y * d.x};
      const float a = dot(d, d), h = r2 * a - dot(k, k);
      return h > 0 ? (-dot(o, d) - sqrtf(h)) / a : kMiss;
    }
    case 3: {
      const float r2 = s.size[0] * s.size[0], length = s.size[1];
      const float k = o.x * d.y - o.y * d.x, a = most(d.x * d.x + d.y * d.y, 1e-30f), h = r2 * a - k * k;
      if (!(h > 0)) return kMiss;
      const float b = o.x * d.x + o.y * d.y, side = (-b - sqrtf(h)) / a, z = o.z + side * d.z;
      if (fabsf(z) <= length) return side;
      const float oz = o.z - copysignf(length, z), ka = o.y * d.z - oz * d.y, kb = oz * d.x - o.x * d.z;
      const float a3 = a + d.z * d.z, h3 = r2 * a3 - (ka * ka + kb * kb + k * k);
      return h3 > 0 ? (-(b + oz * d.z) - sqrtf(h3)) / a3 : kMiss;
    }
    case 5: {
      const float k = o.x * d.y - o.y * d.x, a = most(d.x * d.x + d.y * d.y, 1e-30f),
                  h = s.size[0] * s.size[0] * a - k * k;
      if (!(h > 0)) return kMiss;
      const float b = o.x * d.x + o.y * d.y, root = sqrtf(h);
      const float z0 = (-s.size[1] - o.z) / d.z, z1 = (s.size[1] - o.z) / d.z;
      const float in = most((-b - root) / a, least(z0, z1)), out = least((root - b) / a, most(z0, z1));
      return in < out ? in : kMiss;
    }
    default: {
      const float x0 = (-s.size[0] - o.x) / d.x, x1 = (s.size[0] - o.x) / d.x, y0 = (-s.size[1] - o.y) / d.y;
      const float y1 = (s.size[1] - o.y) / d.y, z0 = (-s.size[2] - o.z) / d.z, z1 = (s.size[2] - o.z) / d.z;
      const float in = most(most(least(x0, x1), least(y0, y1)), least(z0, z1));
      const float out = least(least(most(x0, x1), most(y0, y1)), most(z0, z1));
      return in < out ? in : kMiss;
    }
  }
}

DEV V normal(const Solid& s, V p) {
  switch (s.kind) {
    case 0: return {0, 0, 1};
    case 2: return p * (1 / s.size[0]);
    case 3: return V{p.x, p.y, p.z - clampf(p.z, -s.size[1], s.size[1])} * (1 / s.size[0]);
    case 4: {
      const V n = {p.x / (s.size[0] * s.size[0]), p.y / (s.size[1] * s.size[1]), p.z / (s.size[2] * s.size[2])};
      return n * (1 / sqrtf(dot(n, n)));
    }
    case 5: {
      const float beyond = fabsf(p.z) - s.size[1],
                  aside = (p.x * p.x + p.y * p.y) * (0.5f / s.size[0]) - 0.5f * s.size[0];
      if (beyond > aside) return {0, 0, copysignf(1, p.z)};
      return {p.x / s.size[0], p.y / s.size[0], 0};
    }
    default: {
      const float x = fabsf(p.x) - s.size[0], y = fabsf(p.y) - s.size[1], z = fabsf(p.z) - s.size[2];
      if (x >= y && x >= z) return {copysignf(1, p.x), 0, 0};
      if (y >= z) return {0, copysignf(1, p.y), 0};
      return {0, 0, copysignf(1, p.z)};
    }
  }
}

DEV V texel(uint32_t t) { return {float(t & 255) / 255, float(t >> 8 & 255) / 255, float(t >> 16 & 255) / 255}; }
DEV V mix(V a, V b, float w) { return a + (b - a) * w; }
DEV V fetch(const uint32_t* texels, const Texture& t, int level, int face, float s, float v) {
  const int w = t.width >> level > 1 ? t.width >> level : 1, h = t.height >> level > 1 ? t.height >> level : 1;
  const uint32_t* at = texels + t.origin[level] + face * (w + 2) * (h + 2);
  const float x = s * w - 0.5f, y = v * h - 0.5f, x0 = floorf(x), y0 = floorf(y);
  at += int(y0) * (w + 2) + int(x0);
  return mix(mix(texel(at[0]), texel(at[1]), x - x0), mix(texel(at[w + 2]), texel(at[w + 3]), x - x0), y - y0);
}
DEV V filter(const uint32_t* texels, const Texture& t, int face, float s, float v, float spread) {
  s = clampf(s, 0, 1);
  v = clampf(v, 0, 1);
  const float level = spread <= 1 ? 0 : least(0.5f * log2f(least(spread, 1e12f)), float(t.levels - 1));
  const int l = int(level);
  if (level <= 0) return fetch(texels, t, 0, face, s, v);
  const int up = l + 1 < t.levels ? l + 1 : l;
  return mix(fetch(texels, t, l, face, s, v), fetch(texels, t, up, face, s, v), level - l);
}

struct Seen {
  V o, a, bx, by, center;
};  // the camera in a solid's frame; the solid's centre in the camera's

DEV V cube(const uint32_t* texels, const Texture& tx, V q, float stretch) {
  const float qx = fabsf(q.x), qy = fabsf(q.y), qz = fabsf(q.z);
  const bool on_x = qx >= qy && qx >= qz, on_y = !on_x && qy >= qz;
  const float major = on_x ? q.x : on_y ? q.y : q.z;
  const bool minus = major < 0;
  const float sc = on_x    ? (minus ? q.z : -q.z)
                   : on_y  ? q.x
                   : minus ? -q.x
                           : q.x,
              tc = on_y ? (minus ? -q.z : q.z) : -q.y;
  const float half = 0.5f / most(fabsf(major), 1e-30f), each = half * tx.width;
  const int face = (on_x ? 0 : on_y ? 2 : 4) + minus;
  return filter(texels, tx, face, sc * half + 0.5f, tc * half + 0.5f, stretch * each * each);
}

DEV V textured(const Solid& s, const Texture& tx, const uint32_t* texels, const Seen& e, V ray, V p, V n, float t,
               float dx) {
  const float over = 1 / dot(n, ray);
  const V ax = (e.bx - ray * (dot(n, e.bx) * over)) * (t * dx), ay = (e.by - ray * (dot(n, e.by) * over)) * (t * dx);
  if (s.mapping == 1) {
    const float u = p.x * s.scale[0] + s.origin[0], v = p.y * s.scale[1] + s.origin[1];
    const float w = s.scale[0] * tx.width, h = s.scale[1] * tx.height;
    const float sx = ax.x * w * ax.x * w + ax.y * h * ax.y * h, sy = ay.x * w * ay.x * w + ay.y * h * ay.y * h;
    return filter(texels, tx, 0, u - floorf(u), v - floorf(v), most(sx, sy));
  }
  const float z = clampf(p.z, -s.fold, s.fold);
  const V q = {p.x * s.scale[0], p.y * s.scale[1], z * s.scale[2] + (p.z - z) * s.scale[3]};
  const V gx = {ax.x * s.scale[0], ax.y * s.scale[1], ax.z * s.scale[2]},
          gy = {ay.x * s.scale[0], ay.y * s.scale[1], ay.z * s.scale[2]};
  return cube(texels, tx, q, most(dot(gx, gx), dot(gy, gy)));
}

struct World {
  const float *xpos, *xmat, *cpos, *cmat, *lpos, *ldir;
};

// Whether something lies between a point and a light.
DEV bool shaded(const Scene& sc, const Solid* solids, const World& w, V point, V to_light, float reach, int own) {
  for (int i = 0; i < sc.solids; ++i) {
    const Solid& s = solids[i];
    if (i == own || s.kind == 0) continue;
    const float* m = w.xmat + 9 * s.geom;
    const V c = vec(w.xpos + 3 * s.geom) - point;
    const float along = dot(c, to_light);
    if (along < -s.radius || dot(c, c) - along * along > s.radius * s.radius) continue;
    const float t = enter(s, local(m, c * -1.f), local(m, to_light));
    if (t > 0 && t < reach) return true;
  }
  return false;
}

// What light gives the place where a ray meets a solid.
DEV V painted(const Scene& sc, const Solid* solids, const Texture* textures, const uint32_t* texels,
              const Light* lights, const World& w, const Seen* seen, int hit, int camera, float x, float y, float t,
              float dx) {
  const Solid& s = solids[hit];
  const Seen& e = seen[hit];
  const V ray = e.a + e.bx * x + e.by * y, p = e.o + ray * t, n = normal(s, p);
  const V to_eye = s.specular > 0 ? ray * (-1 / sqrtf(dot(ray, ray))) : ray;
  const float along_eye = dot(n, to_eye);
  V color = vec(s.emission), extra = {0, 0, 0};  // extra: of lights with shadows
  const V rgb = vec(s.rgb);
  const float* m = w.xmat + 9 * s.geom;
  for (int k = 0; k < sc.lights; ++k) {
    const Light& l = lights[k];
    const V direction = local(m, l.index < 0 ? column(w.cmat + 9 * camera, 2) * -1.f : vec(w.ldir + 3 * l.index));
    float strength = 1, reach = kMiss;
    V to_light = direction * -1.f;
    if (!l.directional) {
      to_light = local(m, vec(w.lpos + 3 * l.index) - vec(w.xpos + 3 * s.geom)) - p;
      const float square = dot(to_light, to_light), length = sqrtf(square);
      to_light = to_light * (1 / length);
      reach = length;
      if (l.attenuated) strength = 1 / (l.attenuation[0] + l.attenuation[1] * length + l.attenuation[2] * square);
      if (l.spot) {
        const float cosine = -dot(to_light, direction);
        if (cosine < l.cutoff) continue;
        strength *= powf(most(cosine, 0), l.exponent);
      }
    }
    const float along = dot(n, to_light), facing = most(along, 0);
    float glint = 0;
    if (s.specular > 0 && l.bright && facing > 0) {
      const float cosine = most(along + along_eye, 0) / sqrtf(most(2 + 2 * dot(to_light, to_eye), 1e-6f));
      glint = s.specular * powf(least(cosine, 1), s.exponent);
    }
    const V d = (vec(l.ambient) + vec(l.diffuse) * facing) * strength, g = vec(l.specular) * (glint * strength);
    const V add = {rgb.x * d.x + g.x, rgb.y * d.y + g.y, rgb.z * d.z + g.z};
    if (sc.shadows && l.shadow) {
      if (facing <= 0) continue;
      const V lw = {dot(vec(m), to_light), dot(vec(m + 3), to_light), dot(vec(m + 6), to_light)};
      const V pw = vec(w.xpos + 3 * s.geom) + V{dot(vec(m), p), dot(vec(m + 3), p), dot(vec(m + 6), p)};
      if (!shaded(sc, solids, w, pw, lw, reach, hit)) extra = extra + white(add);
    } else {
      color = color + add;
    }
  }
  color = white(color) + extra;
  if (s.mapping) {
    const V tx = textured(s, textures[s.texture], texels, e, ray, p, n, t, dx);
    color = {color.x * tx.x, color.y * tx.y, color.z * tx.z};
  }
  return white(color);
}

DEV uint32_t pixel(const Scene& sc, const Solid* solids, const Texture* textures, const uint32_t* texels,
                   const Light* lights, const World& w, const Seen* seen, unsigned long long mask, int camera, float x,
                   float y, float dx, int* id) {
  float t = kMiss;
  int hit = -1;
  for (int i = 0; mask >> i; ++i) {
    if (!(mask >> i & 1)) continue;
    const Seen& e = seen[i];
    const V d = e.a + e.bx * x + e.by * y;
    const float at = enter(solids[i], e.o, d);
    if (at > sc.near_plane && at < kMiss && at <= t) {
      t = at;
      hit = i;
    }
  }
  *id = hit < 0 || t > sc.far_plane ? -1 : solids[hit].geom;
  const float* c = w.cmat + 9 * camera;
  const V ray = column(c, 0) * x + column(c, 1) * y - column(c, 2);  // in the world
  const V turned = {ray.x, ray.z, -ray.y};
  if (sc.sky >= 0 &&
      (t * sqrtf(turned.x * turned.x + turned.z * turned.z) > sc.sky_limit || t * fabsf(turned.y) > sc.sky_limit))
    hit = -1;
  V color = {0, 0, 0};
  if (hit >= 0)
    color = painted(sc, solids, textures, texels, lights, w, seen, hit, camera, x, y, t, dx);
  else if (sc.sky >= 0)
    color = cube(texels, textures[sc.sky], turned, dx * dx);
  if (sc.haze_radius > 0 && sc.ground >= 0 && sc.sky >= 0) {
    const float* m = w.xmat + 9 * sc.ground;
    const float height = dot(column(m, 2), vec(w.cpos + 3 * camera) - vec(w.xpos + 3 * sc.ground));
    const V d = local(m, ray);
    if (height >= 0 && d.z < 0) {
      const float level = sqrtf(d.x * d.x + d.y * d.y), drop = -d.z / most(level, 1e-20f),
                  e = height / sc.sky_limit / sc.haze_radius;
      const float distance = e / most(e + drop, 1e-20f), up = 1 - (1 - distance) / sc.haze_radius;
      const float alpha = least(least(up / sc.haze_turn, (1 - up) / (1 - sc.haze_turn)), 1);
      if (alpha > 0 && t * level > distance * sc.sky_limit) color = color * (1 - alpha) + vec(sc.haze) * alpha;
    }
  }
  color = white(color);
  return uint32_t(color.x * 255 + 0.5f) | uint32_t(color.y * 255 + 0.5f) << 8 | uint32_t(color.z * 255 + 0.5f) << 16;
}

DEV Seen look(const Solid& s, const World& w, int camera, float slope, float far_plane, bool* visible) {
  const float *m = w.xmat + 9 * s.geom, *c = w.cmat + 9 * camera;
  const V right = column(c, 0), up = column(c, 1), ahead = column(c, 2) * -1.f;
  const V offset = vec(w.xpos + 3 * s.geom) - vec(w.cpos + 3 * camera);
  Seen e;
  e.center = {dot(right, offset), dot(up, offset), dot(ahead, offset)};
  e.o = local(m, offset * -1.f);
  e.a = local(m, ahead);
  e.bx = local(m, right);
  e.by = local(m, up);
  const float r = s.radius, root = sqrtf(1 + slope * slope);
  *visible = s.kind == 0 ||
             (e.center.z + r > 0 && e.center.z - r < far_plane && fabsf(e.center.x) - slope * e.center.z < r * root &&
              fabsf(e.center.y) - slope * e.center.z < r * root);
  return e;
}
// Whether a solid's ball may show between these slopes.
DEV bool within(const Solid& s, V c, float x0, float x1, float y0, float y1) {
  if (s.kind == 0) return true;
  const float r = s.radius * 1.0001f;
  return c.x - x0 * c.z > -r * sqrtf(1 + x0 * x0) && x1 * c.z - c.x > -r * sqrtf(1 + x1 * x1) &&
         c.y - y0 * c.z > -r * sqrtf(1 + y0 * y0) && y1 * c.z - c.y > -r * sqrtf(1 + y1 * y1);
}

#ifdef __CUDACC__
// A block a picture; a warp a tile of 8 x 4 pixels.
__global__ void __launch_bounds__(256)
    eyes(Scene sc, const Solid* given, const Texture* textures, const uint32_t* texels, const Light* given_lights,
         World all, int geoms, int cameras, int lights_count, unsigned char* out, int* ids) {
  __shared__ Solid solids[kMost];
  __shared__ Seen seen[kMost];
  __shared__ Light lights[kLights];
  __shared__ unsigned long long any;
  const int world = blockIdx.x / cameras, camera = blockIdx.x % cameras;
  World w = {all.xpos + 3ll * geoms * world,        all.xmat + 9ll * geoms * world,
             all.cpos + 3ll * cameras * world,      all.cmat + 9ll * cameras * world,
             all.lpos + 3ll * lights_count * world, all.ldir + 3ll * lights_count * world};
  if (threadIdx.x == 0) any = 0;
  for (int i = threadIdx.x; i < sc.solids * int(sizeof(Solid) / 4); i += blockDim.x)
    ((int*)solids)[i] = ((const int*)given)[i];
  for (int i = threadIdx.x; i < sc.lights * int(sizeof(Light) / 4); i += blockDim.x)
    ((int*)lights)[i] = ((const int*)given_lights)[i];
  __syncthreads();
  if (threadIdx.x < sc.solids) {
    bool visible;
    seen[threadIdx.x] = look(solids[threadIdx.x], w, camera, sc.slope, sc.far_plane, &visible);
    if (visible) atomicOr(&any, 1ull << threadIdx.x);
  }
  __syncthreads();
  const int lane = threadIdx.x & 31, tiles_x = sc.width / 8, tiles = tiles_x * (sc.width / 4);
  const float step = 2 * sc.slope / sc.width;
  for (int tile = threadIdx.x / 32; tile < tiles; tile += blockDim.x / 32) {
    const int c0 = tile % tiles_x * 8, r0 = tile / tiles_x * 4;
    const float x0 = c0 * step - sc.slope, y1 = sc.slope - r0 * step;
    unsigned long long mask = 0;
    for (int half = 0; half < 2; ++half) {
      const int i = lane + 32 * half;
      const bool mine =
          i < sc.solids && (any >> i & 1) && within(solids[i], seen[i].center, x0, x0 + 8 * step, y1 - 4 * step, y1);
      mask |= (unsigned long long)__ballot_sync(~0u, mine) << (32 * half);
    }
    const int column = c0 + lane % 8, row = r0 + lane / 8;
    int id;
    const uint32_t c = pixel(sc, solids, textures, texels, lights, w, seen, mask, camera,
                             (column + 0.5f) * step - sc.slope, sc.slope - (row + 0.5f) * step, step, &id);
    const long long at = ((long long)blockIdx.x * sc.width + row) * sc.width + column;
    out[3 * at] = c;
    out[3 * at + 1] = c >> 8;
    out[3 * at + 2] = c >> 16;
    if (ids) ids[at] = id;
  }
}
#endif

extern "C" int see(const Scene* sc, const Solid* solids, const Texture* textures, const uint32_t* texels,
                   const Light* lights, const float* xpos, const float* xmat, const float* cpos, const float* cmat,
                   const float* lpos, const float* ldir, int worlds, int geoms, int cameras, int lights_count,
                   unsigned char* out, int* ids, void* stream) {
  if (sc->solids > kMost || sc->lights > kLights) return -1;
  const World all = {xpos, xmat, cpos, cmat, lpos, ldir};
#ifdef __CUDACC__
  eyes<<<worlds * cameras, 256, 0, (cudaStream_t)stream>>>(*sc, solids, textures, texels, lights, all, geoms, cameras,
                                                           lights_count, out, ids);
  return cudaGetLastError();
#else
  (void)stream;
  for (int b = 0; b < worlds * cameras; ++b) {
    const int world = b / cameras, camera = b % cameras;
    World w = {all.xpos + 3ll * geoms * world,        all.xmat + 9ll * geoms * world,
               all.cpos + 3ll * cameras * world,      all.cmat + 9ll * cameras * world,
               all.lpos + 3ll * lights_count * world, all.ldir + 3ll * lights_count * world};
    Seen seen[kMost];
    unsigned long long any = 0;
    for (int i = 0; i < sc->solids; ++i) {
      bool v;
      seen[i] = look(solids[i], w, camera, sc->slope, sc->far_plane, &v);
      if (v) any |= 1ull << i;
    }
    const float step = 2 * sc->slope / sc->width;
    for (int row = 0; row < sc->width; ++row)
      for (int column = 0; column < sc->width; ++column) {
        const float x0 = column / 8 * 8 * step - sc->slope, y1 = sc->slope - row / 4 * 4 * step;
        unsigned long long mask = 0;
        for (int i = 0; i < sc->solids; ++i)
          if ((any >> i & 1) && within(solids[i], seen[i].center, x0, x0 + 8 * step, y1 - 4 * step, y1))
            mask |= 1ull << i;
        int id;
        const uint32_t c = pixel(*sc, solids, textures, texels, lights, w, seen, mask, camera,
                                 (column + 0.5f) * step - sc->slope, sc->slope - (row + 0.5f) * step, step, &id);
        const long long at = ((long long)b * sc->width + row) * sc->width + column;
        out[3 * at] = c;
        out[3 * at + 1] = c >> 8;
        out[3 * at + 2] = c >> 16;
        if (ids) ids[at] = id;
      }
  }
  return 0;
#endif
}
