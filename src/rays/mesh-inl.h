// Where rays meet meshes, and what is there.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_MESH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_MESH_INL_H
#undef MIMO_RAYS_MESH_INL_H
#else
#define MIMO_RAYS_MESH_INL_H
#endif

#include <cstddef>
#include <cstdint>

#include "rays/lanes-inl.h"
#include "rays/meshes.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

struct Ray {
  V3 o, d;
};

HWY_INLINE V3 Cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A triangle and rays that may meet it.
struct Meeting {
  V3 e1, e2, s, q;
  V ahead;

  HWY_INLINE Meeting(const V3& o, const V3& corner, const V3& edge1, const V3& edge2) : e1(edge1), e2(edge2) {
    s = o - corner;
    q = Cross(s, e1);
    ahead = Dot(e2, q);
  }

  // The same triangle and rays from elsewhere, where these are from the origin.
  HWY_INLINE Meeting from(const V3& o) const {
    Meeting other = *this;
    other.s = s + o;
    other.q = Cross(other.s, e1);
    other.ahead = Dot(e2, other.q);
    return other;
  }

  // Those of `which` that do, and where. kBackToo: from behind as well.
  template <bool kBackToo>
  HWY_INLINE M at(const V3& d, M which, V& t) const {
    const V least = Set(-1e-6F);  // neighbours must not leave a gap
    const V most = Set(1 + 1e-6F);
    const V3 p = Cross(d, e2);
    const V det = Dot(e1, p);
    const M hit = hn::And(which, kBackToo ? hn::Ne(det, Zero()) : hn::Gt(det, Zero()));
    const V over = Set(1.0F) / Pick(hit, det, Set(1.0F));
    const V u = Dot(s, p) * over;
    const V v = Dot(d, q) * over;
    t = ahead * over;
    return hn::And(hn::And(hit, hn::Ge(u, least)), hn::And(hn::Ge(v, least), hn::Le(u + v, most)));
  }
};

// The rays that meet a box before what they have met already.
HWY_INLINE M MeetBox(const Node& node, const Ray& ray, const V3& over, V from, V limit) {
  const V3 low = (Set(node.low) - ray.o);
  const V3 high = (Set(node.high) - ray.o);
  const V3 a = {low.x * over.x, low.y * over.y, low.z * over.z};
  const V3 b = {high.x * over.x, high.y * over.y, high.z * over.z};
  const V in = hn::Max(hn::Max(hn::Min(a.x, b.x), hn::Min(a.y, b.y)), hn::Min(a.z, b.z));
  const V out = hn::Min(hn::Min(hn::Max(a.x, b.x), hn::Max(a.y, b.y)), hn::Max(a.z, b.z));
  const V slack = hn::Abs(in) * Set(1e-5F);
  return hn::And(hn::Le(in - slack, out + slack), hn::And(hn::Le(in - slack, limit), hn::Ge(out + slack, from)));
}

// The rays that meet anything of a mesh, from either side, from `from` on and before `limit`.
HWY_NOINLINE M IsInTheWay(const Mesh& mesh, const Ray& ray, V from, V limit) {
  M met = hn::Lt(Zero(), Zero());
  if (mesh.nodes.empty()) return met;
  const auto over = [](V d) {  // finite
    const V tiny = hn::CopySign(Set(1e-20F), d);
    return Set(1.0F) / Pick(hn::Lt(hn::Abs(d), Set(1e-20F)), tiny, d);
  };
  const V3 inverse = {over(ray.d.x), over(ray.d.y), over(ray.d.z)};
  const float ahead[3] = {hn::GetLane(ray.d.x), hn::GetLane(ray.d.y), hn::GetLane(ray.d.z)};
  std::int32_t stack[Mesh::kDepth];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = mesh.nodes[static_cast<std::size_t>(stack[--depth])];
    if (None(MeetBox(node, ray, inverse, from, limit))) continue;
    if (node.child != 0) {
      const int nearer = ahead[node.axis] < 0;
      stack[depth++] = node.child + 1 - nearer;
      stack[depth++] = node.child + nearer;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const Triangle triangle = mesh.triangles[static_cast<std::size_t>(i)];
      const Meeting meeting(ray.o, Set(triangle.corner), Set(triangle.edge1), Set(triangle.edge2));
      V t;
      const M hit = meeting.at<true>(ray.d, hn::Gt(limit, from), t);
      met = hn::Or(met, hn::And(hit, hn::And(hn::Ge(t, from), hn::Lt(t, limit))));
    }
    limit = Pick(met, Set(-kMiss), limit);  // nothing more is asked of those
    if (All(hn::Le(limit, from))) break;    // from is -kMiss towards lights without a place
  }
  return met;
}

// Some floats of several places, a vector of the first ones, of the second ones, and so on. (Four at a time and turned:
// a gather of each takes three times as long.)
template <int kCount>
struct Columns {
  static_assert(kCount % 4 == 0);
  alignas(64) float of[kCount][hn::MaxLanes(D())];

  // The floats `skip` and the next three are not read.
  HWY_INLINE void read(const float* from, const std::int32_t* at, int skip) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
#if HWY_TARGET == HWY_SCALAR
    for (int lane = 0; lane < lanes; ++lane) {
      for (int k = 0; k < kCount; ++k) of[k][lane] = from[at[lane] + k];
    }
    (void)skip;
#else
    const hn::Full128<float> d;
    for (int lane = 0; lane < lanes; lane += 4) {
      const float* const row[4] = {from + at[lane], from + at[lane + 1], from + at[lane + 2], from + at[lane + 3]};
      for (int k = 0; k < kCount; k += 4) {
        if (k == skip) continue;
        const auto a = hn::LoadU(d, row[0] + k), b = hn::LoadU(d, row[1] + k);
        const auto c = hn::LoadU(d, row[2] + k), e = hn::LoadU(d, row[3] + k);
        const auto low_ab = hn::InterleaveLower(d, a, b), high_ab = hn::InterleaveUpper(d, a, b);
        const auto low_ce = hn::InterleaveLower(d, c, e), high_ce = hn::InterleaveUpper(d, c, e);
        hn::Store(hn::ConcatLowerLower(d, low_ce, low_ab), d, of[k] + lane);
        hn::Store(hn::ConcatUpperUpper(d, low_ce, low_ab), d, of[k + 1] + lane);
        hn::Store(hn::ConcatLowerLower(d, high_ce, high_ab), d, of[k + 2] + lane);
        hn::Store(hn::ConcatUpperUpper(d, high_ce, high_ab), d, of[k + 3] + lane);
      }
    }
#endif
  }
};

// What of the points of triangles is asked.
enum class Known { kNormals, kTexture };

// What is known of points p of triangles `face`. Each of these must be one of this mesh: lanes whose result is not used
// read, too.
template <Known kKnown>
class SurfaceAt {
 public:
  HWY_INLINE SurfaceAt(const Mesh& mesh, VI face, const V3& p) {
    alignas(64) std::int32_t at[hn::MaxLanes(D())];
    hn::Store(hn::Mul(face, SetI(kSurfaceFloats)), DI(), at);
    numbers_.read(mesh.surfaces[0].corner.data(), at, kKnown == Known::kNormals ? 20 : 12);
    const V3 from_corner = p - three(0);
    u_ = Dot(three(3), from_corner);
    v_ = Dot(three(6), from_corner);
  }

  HWY_INLINE V3 normal() const {
    static_assert(kKnown == Known::kNormals);
    const V3 n = three(9) + three(12) * u_ + three(15) * v_;
    return n * Rsqrt(hn::Max(Dot(n, n), Set(1e-20F)));
  }
  HWY_INLINE V texture(int k) const {
    static_assert(kKnown == Known::kTexture);
    return get(18 + k) + get(20 + k) * u_ + get(22 + k) * v_;
  }
  // By how much a texture coordinate changes along a way on the triangle.
  HWY_INLINE V change(int k, const V3& way) const {
    static_assert(kKnown == Known::kTexture);
    return get(20 + k) * Dot(three(3), way) + get(22 + k) * Dot(three(6), way);
  }

 private:
  HWY_INLINE V get(int k) const { return Load(numbers_.of[k]); }
  HWY_INLINE V3 three(int k) const { return {get(k), get(k + 1), get(k + 2)}; }

  Columns<kSurfaceFloats> numbers_;
  V u_, v_;
};

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
