// Meshes: points strewn over the triangles, none nearer to another than the others allow (dart throwing), the same in
// every run.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "base/angle.h"
#include "base/random.h"
#include "senses/touch/hull.h"
#include "senses/touch/point_tree.h"
#include "senses/touch/surface.h"

namespace mimo::senses::touch {
namespace {

// So near may two points be, in spacings: then there is about one for each square of a spacing.
constexpr double kNearest = 0.77;
constexpr double kDarts = 24;  // for each such square

// The two sides of a thin part look opposite ways; they do not push each other's points away.
bool same_side(const SurfacePoint& one, const SurfacePoint& other) { return one.normal.dot(other.normal) > -0.5; }

class Strewn {
 public:
  explicit Strewn(double apart) : apart_(apart) {}

  // Keeps the point, unless one that was kept is too near.
  void offer(const SurfacePoint& point) {
    const Cell cell = cell_of(point.position);
    for (int step = 0; step < 27; ++step) {
      const auto found = cells_.find(key({cell[0] + step % 3 - 1, cell[1] + step / 3 % 3 - 1, cell[2] + step / 9 - 1}));
      if (found == cells_.end()) continue;
      for (const int kept : found->second) {
        const SurfacePoint& other = points_[static_cast<std::size_t>(kept)];
        if ((other.position - point.position).norm() < apart_ && same_side(other, point)) return;
      }
    }
    cells_[key(cell)].push_back(static_cast<int>(points_.size()));
    points_.push_back(point);
  }

  std::vector<SurfacePoint> take() { return std::move(points_); }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Vec3& place) const {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::int64_t>(std::floor(place[static_cast<Eigen::Index>(axis)] / apart_));
    }
    return cell;
  }

  // Cells that share a key are merely looked through together.
  static std::uint64_t key(const Cell& cell) {
    std::uint64_t key = 0;
    for (const std::int64_t part : cell) key = key * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(part);
    return key;
  }

  double apart_;
  std::vector<SurfacePoint> points_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

// Places on a surface, one as likely as the other.
class Darts {
 public:
  explicit Darts(const Hull& hull) : hull_(hull) {
    double sum = 0;
    for (const Triangle& triangle : hull.triangles) up_to_.push_back(sum += triangle.area);
  }

  SurfacePoint next() {
    const auto at = std::lower_bound(up_to_.begin(), up_to_.end(), random_.uniform() * up_to_.back());
    const Triangle& triangle = hull_.triangles[static_cast<std::size_t>(at - up_to_.begin())];
    double first = random_.uniform(), second = random_.uniform();
    if (first + second > 1) {
      first = 1 - first;
      second = 1 - second;
    }
    return {triangle.corner + first * triangle.first + second * triangle.second, triangle.normal};
  }

 private:
  const Hull& hull_;
  std::vector<double> up_to_;
  Random random_{1};
};

void link(Surface& surface, double apart) {
  std::vector<Vec3> places;
  for (const SurfacePoint& point : surface.points) places.push_back(point.position);
  const PointTree tree(places, 0);
  for (int i = 0; i < static_cast<int>(places.size()); ++i) {
    const SurfacePoint& own = surface.points[static_cast<std::size_t>(i)];
    tree.within(own.position, 2 * apart, [&](int other, double) {
      const bool towards = own.normal.dot(surface.points[static_cast<std::size_t>(other)].normal) > -0.1;
      if (other > i && towards) surface.edges.emplace_back(i, other);
    });
  }
}

}  // namespace

Surface sample_mesh(const Hull& hull, double spacing) {
  const double squares = hull.area() / (spacing * spacing);
  if (squares < 4 * kPi) return single_point();  // a sphere of that area would have one point
  Strewn strewn(kNearest * spacing);
  Darts darts(hull);
  for (double thrown = 0; thrown < kDarts * squares; ++thrown) strewn.offer(darts.next());
  Surface surface{strewn.take(), {}};
  link(surface, kNearest * spacing);
  return surface;
}

}  // namespace mimo::senses::touch
