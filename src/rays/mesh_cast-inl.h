// The rays of one tile, cast at a mesh.
// Compiled once for each instruction set, see kernels.cpp.
#if defined(MIMO_RAYS_MESH_CAST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MIMO_RAYS_MESH_CAST_INL_H
#undef MIMO_RAYS_MESH_CAST_INL_H
#else
#define MIMO_RAYS_MESH_CAST_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "rays/camera.h"
#include "rays/lanes-inl.h"
#include "rays/mesh-inl.h"
#include "rays/pencil-inl.h"
#include "rays/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mimo::rays {
namespace HWY_NAMESPACE {

// What the rays of a tile have met so far.
struct Met {
  float* HWY_RESTRICT best;         // depth
  std::int32_t* HWY_RESTRICT id;    // of an aspect
  std::int32_t* HWY_RESTRICT face;  // of a mesh
};

// The rays of a tile on their way to a mesh. Of a triangle as large as many rays, each vector is one of rays; of
// smaller ones, it is one of triangles, each with a ray of its own. Of triangles equally near a ray meets the one with
// the lowest number, so that the order does not matter in which they are looked at.
template <bool kFromEach>
class MeshCast {
 public:
  MeshCast(const Aspect& aspect, int index, const Tile& tile, const Window& w, const float* from, const Met& met)
      : aspect_(aspect),
        index_(index),
        tile_(tile),
        w_(w),
        from_(from),
        met_(met),
        over_{1 / tile.dx, 1 / tile.dy},
        hair_{kMargin + kHairOfOutline * (1 + kAside) * std::abs(over_[0]),
              kMargin + kHairOfOutline * (1 + kAside) * std::abs(over_[1])} {}

  // Triangles `first` and following.
  HWY_INLINE void meet(int first, const Candidates& found) {
    // The rays whose slopes lie within.
    const V x = Set(tile_.x[0]);
    const V y = Set(tile_.y[0]);
    const V over_x = Set(over_[0]);
    const V over_y = Set(over_[1]);
    Group group;
    group.column0 = hn::Max(Place(found.low[0], x, over_x, 1 - kMargin), SetI(w_.column0));
    group.column1 = hn::Min(Place(found.high[0], x, over_x, kMargin), SetI(w_.column1));
    group.row0 = hn::Max(Place(found.high[1], y, over_y, 1 - kMargin), SetI(w_.row0));
    group.row1 = hn::Min(Place(found.low[1], y, over_y, kMargin), SetI(w_.row1));
    const VI columns = hn::Sub(group.column1, group.column0);  // one less
    const VI rows = hn::Sub(group.row1, group.row0);
    auto may = hn::RebindMask(DI(), found.may);
    may = hn::AndNot(hn::Lt(hn::Min(columns, rows), hn::Zero(DI())), may);
    if (hn::AllFalse(DI(), may)) return;
    group.found = &found;
    group.number = hn::Iota(DI(), first);
    const auto one = hn::And(may, hn::Eq(hn::Or(columns, rows), hn::Zero(DI())));
    if (!hn::AllFalse(DI(), one)) keep_one(group, one);
    may = hn::AndNot(one, may);
    if (hn::AllFalse(DI(), may)) return;
    for (int corner = 0; corner < 3; ++corner) {
      group.at[corner][0] = (found.at[corner][0] - x) * over_x;
      group.at[corner][1] = (found.at[corner][1] - y) * over_y;
    }
    const auto along = [&](int to, int k) { return group.at[to][k] - group.at[0][k]; };
    M small = hn::Le(hn::Abs(along(1, 0) * along(2, 1) - along(2, 0) * along(1, 1)), Set(2.0F * kSmall));
    for (int k = 0; k < 2; ++k) {
      small = hn::And(small, hn::And(hn::Gt(found.low[k], Set(-kAside)), hn::Lt(found.high[k], Set(kAside))));
    }
    const auto kept = hn::And(hn::And(may, hn::RebindMask(DI(), small)), hn::Lt(rows, SetI(kRows)));
    const auto others = hn::AndNot(kept, may);
    if (!hn::AllFalse(DI(), kept)) keep(group, kept);
    if (!hn::AllFalse(DI(), others)) meet_large(group, others);
  }

  // All that were found have been met.
  void finish() {
    run(0, some_.count);
    some_.count = 0;
    run_ones(one_.count);
    one_.count = 0;
  }

 private:
  // What is met a vector of triangles at a time: up to so many rays' area and rows, near the middle of what is seen.
  static constexpr float kSmall = 8;
  static constexpr int kRows = 8;
  static constexpr float kAside = 4;
  static constexpr int kKept = 64;  // of those, before they are
  static constexpr int kRoom = kKept + kTile;
  static constexpr float kMargin = 0.02F;  // of the distance of rays, for what is rounded

  // Triangles, and the rays that may meet them.
  struct Group {
    const Candidates* found;
    V at[3][2];  // corners, in columns and rows
    VI column0, column1, row0, row1;
    VI number;
  };

  // The whole number, in -1..kTile + 1, that is `more` above where a slope is, cut off.
  static HWY_INLINE VI Place(V slope, V first, V over, float more) {
    return CutOff((slope - first) * over + Set(more));
  }
  static HWY_INLINE VI CutOff(V v) {
    const V least = Set(-1.0F);
    return hn::ConvertTo(DI(), hn::Min(Pick(hn::Gt(v, least), v, least), Set(kTile + 1.0F)));
  }

  // Triangles that wait.
  struct Kept {
    int count = 0;
    alignas(64) float triangle[9][kRoom];
    alignas(64) std::int32_t rays[kRoom];
    alignas(64) std::int32_t number[kRoom];

    template <class Mask>
    HWY_INLINE void put(const Group& group, VI of_rays, Mask which) {
      for (int k = 0; k < 9; ++k) put_at(D(), group.found->number[k], which, triangle[k]);
      put_at(DI(), of_rays, which, rays);
      put_at(DI(), group.number, which, number);
    }
    template <class Tag, class Vector, class Mask, class Number>
    HWY_INLINE void put_at(const Tag& d, Vector v, Mask which, Number* to) const {
      hn::StoreU(hn::Compress(v, hn::RebindMask(d, which)), d, to + count);
    }
    void forget(int first) {
      for (auto& numbers : triangle) move(numbers, first);
      move(rays, first);
      move(number, first);
    }
    template <class Number>
    void move(Number* numbers, int first) const {
      std::copy(numbers + first, numbers + count, numbers);
    }
    HWY_INLINE V3 three(int k, int from) const {
      return {Load(triangle[k] + from), Load(triangle[k + 1] + from), Load(triangle[k + 2] + from)};
    }
  };

  // Those that one ray may meet, as most do where there are more triangles than rays.
  template <class Mask>
  HWY_INLINE void keep_one(const Group& group, Mask which) {
    one_.put(group, hn::Add(hn::ShiftLeft<4>(group.row0), group.column0), which);
    one_.count += static_cast<int>(hn::CountTrue(DI(), which));
    if (one_.count < kKept) return;
    run_ones(kKept);
    one_.forget(kKept);
    one_.count -= kKept;
  }

  HWY_NOINLINE void run_ones(int count) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    for (int i = 0; i < count; i += lanes) {
      const auto active = hn::FirstN(DI(), static_cast<std::size_t>(count - i));
      const VI place = hn::IfThenElseZero(active, hn::Load(DI(), one_.rays + i));
      const VI row = hn::ShiftRight<4>(place);
      const Meeting meeting(start(), one_.three(0, i), one_.three(3, i), one_.three(6, i));
      meet_each(meeting, one_.number + i, hn::And(place, SetI(kTile - 1)), row, FindSlope(tile_.y, row),
                hn::RebindMask(D(), active));
    }
  }

  template <class Mask>
  HWY_INLINE void keep(const Group& group, Mask which) {
    const VI rays = hn::Or(hn::Or(group.column0, hn::ShiftLeft<8>(group.column1)),
                           hn::Or(hn::ShiftLeft<16>(group.row0), hn::ShiftLeft<24>(group.row1)));
    some_.put(group, rays, which);
    for (int k = 0; k < 6; ++k) some_.put_at(D(), group.at[k / 2][k % 2], which, at_[k]);
    some_.count += static_cast<int>(hn::CountTrue(DI(), which));
    if (some_.count < kKept) return;
    run(0, kKept);
    some_.forget(kKept);
    for (auto& numbers : at_) some_.move(numbers, kKept);
    some_.count -= kKept;
  }

  HWY_INLINE V3 toward(V x, V y) const { return Set(aspect_.a) + Set(aspect_.by) * y + Set(aspect_.bx) * x; }

  // Where rays start; parallel ones each elsewhere.
  HWY_INLINE V3 start() const { return tile_.parallel ? V3{Zero(), Zero(), Zero()} : Set(aspect_.o); }
  HWY_INLINE M meet_at(const Meeting& meeting, const V3& across, M which, V& t) const {
    if (tile_.parallel) return meeting.from(across).at<false>(Set(aspect_.o), which, t);
    return meeting.at<false>(across, which, t);
  }

  // An edge of the outlines of triangles, from its upper end.
  struct Edge {
    V x, y, along_x, lower, over;

    HWY_INLINE Edge(V ax, V ay, V bx, V by) {
      const M down = hn::Le(ay, by);
      x = Pick(down, ax, bx);
      y = hn::Min(ay, by);
      along_x = Pick(down, bx, ax) - x;
      lower = hn::Max(ay, by);
      over = Set(1.0F) / hn::Max(lower - y, Set(1e-9F));
    }
    // Widens bounds by the part of the edge between two heights.
    HWY_INLINE void widen(V top, V bottom, V& low, V& high) const {
      const auto part = [&](V at) { return hn::Min(hn::Max((at - y) * over, Zero()), Set(1.0F)); };
      const V a = x + part(top) * along_x;
      const V b = x + part(bottom) * along_x;
      const M in = hn::And(hn::Ge(bottom, y), hn::Le(top, lower));
      low = Pick(in, hn::Min(low, hn::Min(a, b)), low);
      high = Pick(in, hn::Max(high, hn::Max(a, b)), high);
    }
  };

  HWY_NOINLINE void run(int from, int to) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    for (int i = from; i < to; i += lanes) run_some(i, std::min(to - i, lanes));
  }

  HWY_INLINE void run_some(int from, int count) {
    const auto edge = [&](int a, int b) {
      return Edge(Load(at_[2 * a] + from), Load(at_[2 * a + 1] + from), Load(at_[2 * b] + from),
                  Load(at_[2 * b + 1] + from));
    };
    const Meeting meeting(start(), some_.three(0, from), some_.three(3, from), some_.three(6, from));
    const Edge edges[3] = {edge(0, 1), edge(1, 2), edge(2, 0)};
    auto active = hn::FirstN(DI(), static_cast<std::size_t>(count));
    const VI rays = hn::IfThenElseZero(active, hn::Load(DI(), some_.rays + from));
    const VI byte = SetI(255);
    const VI column0 = hn::And(rays, byte);
    const VI column1 = hn::And(hn::ShiftRight<8>(rays), byte);
    const VI row1 = hn::ShiftRight<24>(rays);
    VI row = hn::And(hn::ShiftRight<16>(rays), byte);
    do {
      V low = Set(kMiss);
      V high = Set(-kMiss);
      const V middle = Real(row);
      for (const Edge& e : edges) e.widen(middle - Set(hair_[1]), middle + Set(hair_[1]), low, high);
      VI column = hn::Max(CutOff(low + Set(1 - hair_[0])), column0);
      const VI last = hn::Min(CutOff(high + Set(hair_[0])), column1);
      const V y = FindSlope(tile_.y, row);
      for (;;) {
        const auto on = hn::AndNot(hn::Gt(column, last), active);
        if (hn::AllFalse(DI(), on)) break;
        meet_each(meeting, some_.number + from, hn::IfThenElseZero(on, column), row, y, hn::RebindMask(D(), on));
        column = hn::Add(column, SetI(1));
      }
      row = hn::Add(row, SetI(1));
      active = hn::AndNot(hn::Gt(row, row1), active);
      row = hn::Min(row, row1);
    } while (!hn::AllFalse(DI(), active));
  }

  // Each triangle and its ray.
  HWY_INLINE void meet_each(const Meeting& meeting, const std::int32_t* number, VI column, VI row, V y, M on) {
    alignas(64) float depth[hn::MaxLanes(D())];
    alignas(64) std::int32_t place[hn::MaxLanes(D())];
    V t;
    M hit = meet_at(meeting, toward(FindSlope(tile_.x, column), y), on, t);
    if (!kFromEach) hit = hn::And(hit, hn::Ge(t, Set(*from_)));
    if (None(hit)) return;
    Store(t, depth);
    hn::Store(hn::Add(hn::ShiftLeft<4>(row), column), DI(), place);
    EachLane(hit, [&](int lane) { put(place[lane], depth[lane], number[lane]); });
  }

  HWY_INLINE void put(int i, float t, std::int32_t number) {
    if (kFromEach && !(t >= from_[i])) return;
    if (!(t < met_.best[i]) && !(t == met_.best[i] && met_.id[i] == index_ && number < met_.face[i])) return;
    met_.best[i] = t;
    met_.id[i] = index_;
    met_.face[i] = number;
  }

  template <class Mask>
  HWY_NOINLINE void meet_large(const Group& group, Mask which) {
    constexpr std::size_t kMost = hn::MaxLanes(D());
    alignas(64) float triangle[9][kMost];
    alignas(64) std::int32_t rays[4][kMost];
    alignas(64) std::int32_t number[kMost];
    for (int k = 0; k < 9; ++k) Store(group.found->number[k], triangle[k]);
    hn::Store(group.column0, DI(), rays[0]);
    hn::Store(group.column1, DI(), rays[1]);
    hn::Store(group.row0, DI(), rays[2]);
    hn::Store(group.row1, DI(), rays[3]);
    hn::Store(group.number, DI(), number);
    EachLane(hn::RebindMask(D(), which), [&](int lane) {
      const auto three = [&](int k) {
        return V3{Set(triangle[k][lane]), Set(triangle[k + 1][lane]), Set(triangle[k + 2][lane])};
      };
      const Meeting meeting(start(), three(0), three(3), three(6));
      const Window w = {rays[2][lane], rays[3][lane], rays[0][lane], rays[1][lane]};
      meet_rays(meeting, number[lane], w);
    });
  }

  HWY_INLINE void meet_rays(const Meeting& meeting, std::int32_t number, const Window& w) {
    const int lanes = static_cast<int>(hn::Lanes(D()));
    const VI mine = SetI(number);
    for (int row = w.row0; row <= w.row1; ++row) {
      for (int column = w.column0 / lanes * lanes; column <= w.column1; column += lanes) {
        const int i = row * kTile + column;
        V t;
        M hit = meet_at(meeting, toward(Load(tile_.x + column), Set(tile_.y[row])), hn::Eq(Zero(), Zero()), t);
        const V old = Load(met_.best + i);
        const VI id = hn::Load(DI(), met_.id + i);
        const VI face = hn::Load(DI(), met_.face + i);
        const M lower = hn::RebindMask(D(), hn::And(hn::Eq(id, SetI(index_)), hn::Lt(mine, face)));
        hit = hn::And(hit, hn::Or(hn::Lt(t, old), hn::And(hn::Eq(t, old), lower)));
        hit = hn::And(hit, hn::Ge(t, kFromEach ? Load(from_ + i) : Set(*from_)));
        if (None(hit)) continue;
        const auto seen = hn::RebindMask(DI(), hit);
        Store(Pick(hit, t, old), met_.best + i);
        hn::Store(hn::IfThenElse(seen, SetI(index_), id), DI(), met_.id + i);
        hn::Store(hn::IfThenElse(seen, mine, face), DI(), met_.face + i);
      }
    }
  }

  const Aspect& aspect_;
  const int index_;
  const Tile& tile_;
  const Window& w_;
  const float* const from_;
  const Met met_;
  const float over_[2];  // the second is negative: rows go down
  const float hair_[2];
  Kept one_;                        // each with its ray's place in the tile
  Kept some_;                       // columns and rows of their rays, a byte each
  alignas(64) float at_[6][kRoom];  // corners of these, in columns and rows
};

template <bool kFromEach>
HWY_NOINLINE void CastAtMesh(const Mesh& mesh, const Aspect& aspect, int index, const Tile& tile, const Window& w,
                             const float* from, const Met& met) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  V farthest = Zero();
  for (int row = w.row0; row <= w.row1; ++row) {
    for (int column = w.column0 / lanes * lanes; column <= w.column1; column += lanes) {
      farthest = hn::Max(farthest, Load(met.best + row * kTile + column));
    }
  }
  const Pencil pencil = {{tile.x[w.column0], tile.y[w.row1]},
                         {tile.x[w.column1], tile.y[w.row0]},
                         hn::GetLane(hn::MaxOfLanes(D(), farthest))};
  MeshCast<kFromEach> cast(aspect, index, tile, w, from, met);
  const Sight sight = SightOf(aspect, tile.parallel);
  const auto meet = [&](int first, const Candidates& found) {
    cast.meet(first, found);
    return false;
  };
  if (tile.parallel) {  // backs are told from a point
    Sifter<true>(mesh, sight, pencil).each(meet);
  } else {
    Sifter<false>(mesh, sight, pencil).each(meet);
  }
  cast.finish();
}

}  // namespace HWY_NAMESPACE
}  // namespace mimo::rays
HWY_AFTER_NAMESPACE();

#endif
