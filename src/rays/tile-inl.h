// The rays of one tile, cast at one solid after the other.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_TILE_INL_H
#undef MIMO_RAYS_TILE_INL_H
#else
#define MIMO_RAYS_TILE_INL_H
#endif

#include <algorithm>
#include <cstdint>

#include "rays/camera.h"
#include "rays/intersect-inl.h"
#include "rays/lanes-inl.h"
#include "rays/pencil-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

struct Strip;

// The rays of one tile and what they meet.
struct Tile {
  Strip* strip;                // the tiles side by side that it is one of
  int place;                   // of its first column in that
  alignas(64) float x[kTile];  // slopes
  float y[kTile];
  float dx, dy;
  alignas(64) float t[kRays];            // depth of the nearest solid, kMiss for none
  alignas(64) std::int32_t id[kRays];    // its aspect, -1 for none
  alignas(64) std::int32_t face[kRays];  // its triangle, if it is a mesh
  float nearest, farthest;               // depths of what the tile shows; nearest > farthest if that is nothing
};

void FindDepths(Tile& tile) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  V least = Set(kMiss);
  V most = Set(-kMiss);
  for (int i = 0; i < kRays; i += lanes) {
    const V t = Load(tile.t + i);
    least = hn::Min(least, t);
    most = hn::Max(most, Pick(hn::Lt(t, Set(kMiss)), t, Set(-kMiss)));
  }
  tile.nearest = hn::GetLane(hn::MinOfLanes(D(), least));
  tile.farthest = hn::GetLane(hn::MaxOfLanes(D(), most));
}

// The rows and columns of a tile that an aspect may touch; empty if first > last.
struct Window {
  int row0, row1, column0, column1;
};

constexpr Window kNothing = {0, -1, 0, -1};

HWY_INLINE bool IsEmpty(const Window& w) { return w.row0 > w.row1 || w.column0 > w.column1; }

// Of what is no number: -1.
HWY_INLINE int Clamped(float v) { return static_cast<int>(std::min(std::max(-1.0F, v), kTile + 1.0F)); }

HWY_INLINE Window WindowOf(const Aspect& aspect, const Tile& tile) {
  // The least of facing over the tile; rays beyond the last are close enough.
  const float far_x = tile.x[0] + tile.dx * kTile;
  const float far_y = tile.y[0] + tile.dy * kTile;
  const float least = aspect.facing[0] + std::min(aspect.facing[1] * tile.x[0], aspect.facing[1] * far_x) +
                      std::min(aspect.facing[2] * tile.y[0], aspect.facing[2] * far_y);
  if (least > 0) return kNothing;
  const float over_x = 1 / tile.dx;
  const float over_y = 1 / tile.dy;  // negative: rows go down
  Window w;
  w.column0 = std::max(Clamped((aspect.left - tile.x[0]) * over_x), 0);
  w.column1 = std::min(Clamped((aspect.right - tile.x[0]) * over_x + 1), kTile) - 1;
  w.row0 = std::max(Clamped((aspect.top - tile.y[0]) * over_y), 0);
  w.row1 = std::min(Clamped((aspect.bottom - tile.y[0]) * over_y + 1), kTile) - 1;
  return w;
}

// Casts the tile's rays at one solid. `from` is the depth from which on it is seen: for all rays, or for each.
template <Form kKind, bool kFromEach>
HWY_NOINLINE void CastAt(const Solid& solid, const Aspect& aspect, int index, const Tile& tile, const Window& w,
                         const float* from, float* HWY_RESTRICT best, std::int32_t* HWY_RESTRICT id) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  const int first = w.column0 / lanes * lanes;
  const V3 bx = Set(aspect.bx);
  const VI index_v = hn::Set(DI(), index);
  Ray ray;
  ray.o = Set(aspect.o);
  for (int row = w.row0; row <= w.row1; ++row) {
    const float y = tile.y[row];
    const V3 base = {Set(aspect.a[0] + y * aspect.by[0]), Set(aspect.a[1] + y * aspect.by[1]),
                     Set(aspect.a[2] + y * aspect.by[2])};
    for (int column = first; column <= w.column1; column += lanes) {
      const int i = row * kTile + column;
      ray.d = base + bx * Load(tile.x + column);
      const V old = Load(best + i);
      const V start = kFromEach ? Load(from + i) : Set(*from);
      const V t = Enter<kKind>(solid, ray);
      const M seen = hn::And(hn::Lt(t, old), hn::Ge(t, start));
      if (None(seen)) continue;
      Store(Pick(seen, t, old), best + i);
      const VI old_id = hn::Load(DI(), id + i);
      hn::Store(hn::IfThenElse(hn::RebindMask(DI(), seen), index_v, old_id), DI(), id + i);
    }
  }
}

// The rays of a tile on their way to a mesh.
template <bool kFromEach>
class MeshCast {
 public:
  MeshCast(const Aspect& aspect, const Tile& tile, const Window& w, const float* from, const float* best)
      : tile_(tile), w_(w), from_(from), over_x_(1 / tile.dx), over_y_(1 / tile.dy) {
    ray_.o = Set(aspect.o);
    each([&](int row, int column, int i) {
      const V3 d = Set(aspect.a) + Set(aspect.by) * Set(tile.y[row]) + Set(aspect.bx) * Load(tile.x + column);
      Store(d.x, d_[0] + i);
      Store(d.y, d_[1] + i);
      Store(d.z, d_[2] + i);
      Store(Load(best + i), t_ + i);
      hn::Store(SetI(-1), DI(), face_ + i);
    });
  }

  HWY_INLINE void meet(const Mesh& mesh, int index, const Outline& outline) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    // The rays whose slopes lie within; a fiftieth of their distance more, for what is rounded.
    const float left = (outline.low[0] - tile_.x[0]) * over_x_ + (1 - 0.02F);
    const float right = (outline.high[0] - tile_.x[0]) * over_x_ + 0.02F;
    const float top = (outline.high[1] - tile_.y[0]) * over_y_ + (1 - 0.02F);
    const float bottom = (outline.low[1] - tile_.y[0]) * over_y_ + 0.02F;
    const int first = std::max(Clamped(left), w_.column0);
    const int last = std::min(Clamped(right), w_.column1);
    const int row0 = std::max(Clamped(top), w_.row0);
    const int row1 = std::min(Clamped(bottom), w_.row1);
    if (first > last || row0 > row1) return;
    const Triangle triangle = mesh.triangles[static_cast<std::size_t>(index)];
    for (int row = row0; row <= row1; ++row) {
      for (int column = first / lanes * lanes; column <= last; column += lanes) {
        const int i = row * kTile + column;
        ray_.d = {Load(d_[0] + i), Load(d_[1] + i), Load(d_[2] + i)};
        Encounter nearest = {Load(t_ + i), hn::Load(DI(), face_ + i)};
        MeetTriangle<false>(triangle, index, ray_, kFromEach ? Load(from_ + i) : Set(*from_), nearest);
        Store(nearest.t, t_ + i);
        hn::Store(nearest.face, DI(), face_ + i);
      }
    }
  }

  void finish(int index, float* HWY_RESTRICT best, std::int32_t* HWY_RESTRICT id,
              std::int32_t* HWY_RESTRICT face) const {
    each([&](int, int, int i) {
      const VI mine = hn::Load(DI(), face_ + i);
      const auto seen = hn::Gt(mine, SetI(-1));
      Store(Load(t_ + i), best + i);
      hn::Store(hn::IfThenElse(seen, mine, hn::Load(DI(), face + i)), DI(), face + i);
      hn::Store(hn::IfThenElse(seen, SetI(index), hn::Load(DI(), id + i)), DI(), id + i);
    });
  }

 private:
  template <class Each>
  HWY_INLINE void each(const Each& function) const {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    for (int row = w_.row0; row <= w_.row1; ++row) {
      for (int column = w_.column0 / lanes * lanes; column <= w_.column1; column += lanes) {
        function(row, column, row * kTile + column);
      }
    }
  }

  const Tile& tile_;
  const Window& w_;
  const float* const from_;
  const float over_x_, over_y_;  // the second is negative: rows go down
  Ray ray_;
  alignas(64) float d_[3][kRays];
  float t_[kRays];
  std::int32_t face_[kRays];
};

template <bool kFromEach>
HWY_NOINLINE void CastAtMesh(const Mesh& mesh, const Aspect& aspect, int index, const Tile& tile, const Window& w,
                             const float* from, float* HWY_RESTRICT best, std::int32_t* HWY_RESTRICT id,
                             std::int32_t* HWY_RESTRICT face) {
  MeshCast<kFromEach> cast(aspect, tile, w, from, best);
  float farthest = 0;
  for (int row = w.row0; row <= w.row1; ++row) {
    for (int column = w.column0; column <= w.column1; ++column) {
      farthest = std::max(farthest, best[row * kTile + column]);
    }
  }
  const Pencil pencil = {{tile.x[w.column0], tile.y[w.row1]}, {tile.x[w.column1], tile.y[w.row0]}, farthest};
  Sifter(mesh, aspect, pencil).each([&](int i, const Outline& outline) { cast.meet(mesh, i, outline); });
  cast.finish(index, best, id, face);
}

template <bool kFromEach>
void Cast(const Solids& solids, const Eye& eye, int index, const Tile& tile, const Window& w, const float* from,
          float* best, std::int32_t* id, std::int32_t* face) {
  const Aspect& aspect = eye.aspects[index];
  const Solid& solid = solids[aspect.solid];
  switch (solid.kind) {
    case Form::kPlane: CastAt<Form::kPlane, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Form::kSphere: CastAt<Form::kSphere, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Form::kCapsule: CastAt<Form::kCapsule, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Form::kEllipsoid: CastAt<Form::kEllipsoid, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Form::kCylinder: CastAt<Form::kCylinder, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Form::kBox: CastAt<Form::kBox, kFromEach>(solid, aspect, index, tile, w, from, best, id); break;
    case Form::kMesh: CastAtMesh<kFromEach>(*solid.mesh, aspect, index, tile, w, from, best, id, face); break;
  }
}

// Forgets what the rays have met.
inline void StartTile(const Solids& solids, Tile& tile) {
  std::fill_n(tile.t, kRays, kMiss);
  std::fill_n(tile.id, kRays, -1);
  if (solids.meshes()) std::fill_n(tile.face, kRays, 0);
}

// Where the rays of a tile meet the solid that one of the camera's aspects shows.
inline void Meet(const Solids& solids, const Camera& camera, int index, Tile& tile) {
  const Window w = WindowOf(camera.aspects[index], tile);
  if (!IsEmpty(w)) Cast<false>(solids, camera, index, tile, w, &camera.near_plane, tile.t, tile.id, tile.face);
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
