// Forces on the skin of many worlds, from contacts that lie on a graphics card: a warp for each side of a contact. The
// force is shared among the sensors within two spacings, by their distance on the tangent plane of the nearest one;
// src/senses/touch takes the distance along the skin instead, from maps that this probe does not have.
#include <cuda_runtime.h>
struct Skin {
  const float *position, *frame;
  const int *geom_first, *geom_count, *body_first, *body_count, *body_of;
  const float* spacing;
  int sensors;
};
struct Contacts {
  const int* count;
  const float *pos, *frame, *dist;
  const int *geom, *world;
  const float* force;
};
__device__ float3 at(const float* p) { return make_float3(p[0], p[1], p[2]); }
__device__ float dot(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
__device__ float sum(float v) {
  for (int k = 16; k; k /= 2) v += __shfl_xor_sync(~0u, v, k);
  return v;
}
__global__ void skin_forces(Skin skin, Contacts c, const float* xpos, const float* xmat, int bodies, float* out) {
  const int lane = threadIdx.x & 31, warps = gridDim.x * blockDim.x / 32;
  for (int job = (blockIdx.x * blockDim.x + threadIdx.x) / 32; job < 2 * *c.count; job += warps) {
    const int contact = job / 2, side = job & 1, geom = c.geom[2 * contact + side];
    if (geom < 0) continue;
    const int body = skin.body_of[geom], world = c.world[contact];
    const float* force6 = c.force + 6 * contact;
    if (skin.body_count[body] == 0 || !(force6[0] > 1e-9f)) continue;
    const float *f = c.frame + 9 * contact, sign = side == 0 ? 1 : -1;
    const float* m = xmat + 9ll * (world * (long long)bodies + body);
    const float3 center = at(xpos + 3ll * (world * (long long)bodies + body));
    float3 p = at(c.pos + 3 * contact);
    const float half = -0.5f * c.dist[contact] * sign;
    p = make_float3(p.x + half * f[0] - center.x, p.y + half * f[1] - center.y, p.z + half * f[2] - center.z);
    const float3 w = make_float3(-sign * (f[0] * force6[0] + f[3] * force6[1] + f[6] * force6[2]),
                                 -sign * (f[1] * force6[0] + f[4] * force6[1] + f[7] * force6[2]),
                                 -sign * (f[2] * force6[0] + f[5] * force6[1] + f[8] * force6[2]));
    const float3 q = make_float3(m[0] * p.x + m[3] * p.y + m[6] * p.z, m[1] * p.x + m[4] * p.y + m[7] * p.z,
                                 m[2] * p.x + m[5] * p.y + m[8] * p.z);
    const float3 g = make_float3(m[0] * w.x + m[3] * w.y + m[6] * w.z, m[1] * w.x + m[4] * w.y + m[7] * w.z,
                                 m[2] * w.x + m[5] * w.y + m[8] * w.z);
    int first = skin.geom_first[geom], count = skin.geom_count[geom];
    if (count == 0) {
      first = skin.body_first[body];
      count = skin.body_count[body];
    }
    float best = 1e30f;
    int nearest = first;
    for (int i = first + lane; i < first + count; i += 32) {
      const float3 s = at(skin.position + 3 * i), d = make_float3(s.x - q.x, s.y - q.y, s.z - q.z);
      if (dot(d, d) < best) {
        best = dot(d, d);
        nearest = i;
      }
    }
    for (int k = 16; k; k /= 2) {
      const float other = __shfl_xor_sync(~0u, best, k);
      const int whose = __shfl_xor_sync(~0u, nearest, k);
      if (other < best || (other == best && whose < nearest)) {
        best = other;
        nearest = whose;
      }
    }
    const float spacing = skin.spacing[body];
    const float3 normal = at(skin.frame + 9 * nearest), t1 = at(skin.frame + 9 * nearest + 3),
                 t2 = at(skin.frame + 9 * nearest + 6);
    const auto weight = [&](int i) {
      const float3 s = at(skin.position + 3 * i), d = make_float3(s.x - q.x, s.y - q.y, s.z - q.z);
      if (dot(d, d) >= 9 * spacing * spacing || dot(normal, at(skin.frame + 9 * i)) <= 0) return 0.f;
      const float x = dot(t1, d), y = dot(t2, d), r = 1 - sqrtf(x * x + y * y) / (2 * spacing);
      return r > 0 ? r : 0.f;
    };
    float total = 0;
    for (int i = skin.body_first[body] + lane; i < skin.body_first[body] + skin.body_count[body]; i += 32)
      total += weight(i);
    total = sum(total);
    float* to = out + 3ll * skin.sensors * world;
    if (!(total > 0)) {
      if (lane == 0) {
        atomicAdd(to + 3 * nearest, g.x);
        atomicAdd(to + 3 * nearest + 1, g.y);
        atomicAdd(to + 3 * nearest + 2, g.z);
      }
      continue;
    }
    for (int i = skin.body_first[body] + lane; i < skin.body_first[body] + skin.body_count[body]; i += 32) {
      const float share = weight(i) / total;
      if (share > 0) {
        atomicAdd(to + 3 * i, share * g.x);
        atomicAdd(to + 3 * i + 1, share * g.y);
        atomicAdd(to + 3 * i + 2, share * g.z);
      }
    }
  }
}
extern "C" int feel(const Skin* skin, const Contacts* c, const float* xpos, const float* xmat, int bodies, int worlds,
                    float* out, void* stream) {
  cudaMemsetAsync(out, 0, 12ull * skin->sensors * worlds, (cudaStream_t)stream);
  skin_forces<<<132 * 16, 128, 0, (cudaStream_t)stream>>>(*skin, *c, xpos, xmat, bodies, out);
  return cudaGetLastError();
}
