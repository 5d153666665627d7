// Boxes: a grid on each face, shared along edges and at corners.
#include <algorithm>
#include <array>
#include <cmath>

#include "senses/touch/surface.h"

namespace mimo::senses::touch {
namespace {

using Cell = std::array<int, 3>;

class BoxGrid {
 public:
  BoxGrid(const Vec3& half, double spacing) : half_(half) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double cells = std::ceil(2 * half[static_cast<Eigen::Index>(axis)] / spacing);
      count_[axis] = std::max(2, static_cast<int>(cells));
    }
    number_points();
  }

  Surface surface() const {
    Surface surface;
    for (const Cell& cell : cells_) surface.points.push_back({position(cell), sides(cell).normalized()});
    for (std::size_t i = 0; i < cells_.size(); ++i) connect(static_cast<int>(i), surface);
    return surface;
  }

 private:
  // -1, 0 or 1 by axis: which faces the cell lies on. Points on edges and corners look between their faces.
  Vec3 sides(const Cell& cell) const {
    Vec3 side;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      side[static_cast<Eigen::Index>(axis)] = (cell[axis] == count_[axis] - 1) - (cell[axis] == 0);
    }
    return side;
  }

  Vec3 position(const Cell& cell) const {
    Vec3 place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = static_cast<double>(cell[axis]) / (count_[axis] - 1);
      const double half = half_[static_cast<Eigen::Index>(axis)];
      place[static_cast<Eigen::Index>(axis)] = -half + 2 * half * share;
    }
    return place;
  }

  // The cells in the order of their points. A grid line's inner cells are jumped over, not tried: there are many.
  void number_points() {
    for (int x = 0; x < count_[0]; ++x) {
      for (int y = 0; y < count_[1]; ++y) {
        const bool inner = sides({x, y, 1}).head<2>().isZero();
        for (int z = 0; z < count_[2]; z += inner ? count_[2] - 1 : 1) cells_.push_back({x, y, z});
      }
    }
  }

  int index(const Cell& cell) const {
    const auto found = std::lower_bound(cells_.begin(), cells_.end(), cell);
    return found != cells_.end() && *found == cell ? static_cast<int>(found - cells_.begin()) : -1;
  }

  // Neighbours, also diagonal ones, that share a face with the point.
  void connect(int point, Surface& surface) const {
    const Cell& cell = cells_[static_cast<std::size_t>(point)];
    for (int step = 0; step < 27; ++step) {
      const Cell other{cell[0] + step % 3 - 1, cell[1] + step / 3 % 3 - 1, cell[2] + step / 9 - 1};
      if (!(cell < other)) continue;
      const int neighbour = index(other);
      const bool same_face = neighbour >= 0 && (sides(cell).cwiseProduct(sides(other)).array() > 0).any();
      if (same_face) surface.edges.emplace_back(point, neighbour);
    }
  }

  Vec3 half_;
  std::array<int, 3> count_{};
  std::vector<Cell> cells_;  // ascending
};

}  // namespace

Surface sample_box(const Vec3& half, double spacing) {
  if (0.75 * spacing > half.maxCoeff()) return single_point();
  return BoxGrid(half, spacing).surface();
}

}  // namespace mimo::senses::touch
