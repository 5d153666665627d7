#include "senses/touch/point_tree.h"

#include <algorithm>

namespace mimo::senses::touch {

PointTree::PointTree(Span<const Vec3> points, int first_id) {
  nodes_.reserve(points.size());
  for (const Vec3& point : points) nodes_.push_back({point, first_id++, 0});
  build(0, nodes_.size());
}

// Splits along the axis on which the points spread most.
void PointTree::build(std::size_t begin, std::size_t end) {
  if (end - begin < 2) return;
  Vec3 low = nodes_[begin].place, high = low;
  for (std::size_t i = begin; i < end; ++i) {
    low = low.cwiseMin(nodes_[i].place);
    high = high.cwiseMax(nodes_[i].place);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const auto at = [this](std::size_t i) { return nodes_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end), [axis](const Node& a, const Node& b) {
    return a.place[axis] != b.place[axis] ? a.place[axis] < b.place[axis] : a.id < b.id;
  });
  nodes_[middle].axis = axis;
  build(begin, middle);
  build(middle + 1, end);
}

NearestPoint PointTree::nearest(const Vec3& place, NearestPoint best) const {
  search(place, 0, nodes_.size(), best);
  return best;
}

void PointTree::search(const Vec3& place, std::size_t begin, std::size_t end, NearestPoint& best) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const Node& node = nodes_[middle];
  const double square = (node.place - place).squaredNorm();
  // Of equally near points the one with the lowest id, so that the answer does not depend on the tree.
  if (square < best.square || (square == best.square && node.id < best.id)) best = {node.id, square};
  const double beyond = place[node.axis] - node.place[node.axis];
  const bool low_first = beyond < 0;
  low_first ? search(place, begin, middle, best) : search(place, middle + 1, end, best);
  if (beyond * beyond > best.square) return;
  low_first ? search(place, middle + 1, end, best) : search(place, begin, middle, best);
}

}  // namespace mimo::senses::touch
