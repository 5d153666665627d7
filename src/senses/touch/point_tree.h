// A k-d tree of points: which one is nearest, which ones are near. Queries allocate nothing.
#pragma once

#include <limits>
#include <vector>

#include "base/span.h"
#include "senses/touch/shape.h"

namespace mimo::senses::touch {

struct NearestPoint {
  int id = -1;                                              // -1: none
  double square = std::numeric_limits<double>::infinity();  // of the distance, m^2
};

class PointTree {
 public:
  PointTree() = default;
  // Point i gets the id first_id + i.
  PointTree(Span<const Vec3> points, int first_id);

  bool empty() const { return nodes_.empty(); }
  // The nearest point, or `best` if that is nearer still.
  NearestPoint nearest(const Vec3& place, NearestPoint best = {}) const;

  // Calls visit(id, square of the distance) for every point within a radius.
  template <typename Visit>
  void within(const Vec3& place, double radius, Visit&& visit) const {
    visit_near(place, radius * radius, 0, nodes_.size(), visit);
  }

 private:
  // A range of nodes is a subtree; its root stands in the middle, lower coordinates before it.
  struct Node {
    Vec3 place;
    int id;
    int axis;
  };

  void build(std::size_t begin, std::size_t end);
  void search(const Vec3& place, std::size_t begin, std::size_t end, NearestPoint& best) const;

  template <typename Visit>
  void visit_near(const Vec3& place, double limit, std::size_t begin, std::size_t end, Visit& visit) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const Node& node = nodes_[middle];
    const double square = (node.place - place).squaredNorm();
    if (square <= limit) visit(node.id, square);
    const double beyond = place[node.axis] - node.place[node.axis];
    if (beyond <= 0 || beyond * beyond <= limit) visit_near(place, limit, begin, middle, visit);
    if (beyond >= 0 || beyond * beyond <= limit) visit_near(place, limit, middle + 1, end, visit);
  }

  std::vector<Node> nodes_;
};

}  // namespace mimo::senses::touch
