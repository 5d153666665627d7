#include "senses/touch/skin.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"

namespace mimo::senses::touch {
namespace {

constexpr double kMaxSensors = 1e6;

// A contact lies up to a cell from the nearest sensor and reaches two spacings from there.
constexpr double kMapReach = 3;

}  // namespace

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

Skin::Skin(const mjModel& model, const std::vector<BodySpacing>& bodies, const BornGeoms& born)
    : part_of_body_(static_cast<std::size_t>(model.nbody), kNone),
      body_of_geom_(model.geom_bodyid, model.geom_bodyid + model.ngeom),
      trees_(static_cast<std::size_t>(model.ngeom)) {
  double expected = 0;
  for (const BodySpacing& body : bodies) {
    expected += expected_sensors(model, body.body, body.spacing, born);
    require(expected <= kMaxSensors,
            "touch: {:g} m between the sensors of body \"{}\" would make about {:.3g} sensors, expected at most {:g}",
            body.spacing, engine::name(model, engine::Kind::kBody, body.body), expected, kMaxSensors);
  }
  for (const BodySpacing& body : bodies) add(model, body, born);
}

void Skin::add(const mjModel& model, const BodySpacing& body, const BornGeoms& born) {
  const BodySensors made = place_sensors(model, body.body, body.spacing, born);
  if (made.sensors.empty()) return;
  const int first = static_cast<int>(sensors_.size());
  sensors_.insert(sensors_.end(), made.sensors.begin(), made.sensors.end());
  const double spacing = body.spacing * born.stretch(model, geoms_with_skin(model, body.body));
  maps_.add(made, first, kMapReach * spacing);

  part_of_body_[static_cast<std::size_t>(body.body)] = static_cast<int>(parts_.size());
  parts_.push_back({spacing, {}});
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < made.sensors.size(); ++i) {
    const int geom = made.sensors[i].geom;
    points.push_back(made.sensors[i].position);
    if (i + 1 < made.sensors.size() && made.sensors[i + 1].geom == geom) continue;
    const int end = first + static_cast<int>(i) + 1;
    trees_[static_cast<std::size_t>(geom)] = PointTree(points, end - static_cast<int>(points.size()));
    parts_.back().geoms.push_back(geom);
    points.clear();
  }
}

int Skin::nearest(int geom, const Vec3& point) const {
  const PointTree& tree = trees_[static_cast<std::size_t>(geom)];
  if (tree.empty()) return nearest_of_body(body_of_geom_[static_cast<std::size_t>(geom)], point);
  return tree.nearest(point).id;
}

int Skin::nearest_of_body(int body, const Vec3& point) const {
  NearestPoint best;
  for (const int geom : part(body).geoms) best = trees_[static_cast<std::size_t>(geom)].nearest(point, best);
  return best.id;
}

}  // namespace mimo::senses::touch
