#include "senses/touch/skin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"

namespace mimo::senses::touch {
namespace {

// A direction in the tangent plane, or a turn of it.
using Plane = std::complex<double>;

// From a sensor to its neighbour.
struct Step {
  int to;
  double length;  // along the skin
  Plane offset;   // in the tangent plane of the first
  Plane turn;     // of the neighbour's tangents against those of the first, once its plane is tilted into the first's
};

// Between neighbours the skin is taken as an arc of a circle, to which both normals are perpendicular.
Step step_between(const Sensor& from, const Sensor& to, int to_index) {
  const Vec3 chord = to.position - from.position;
  const Vec3 middle = (from.normal() + to.normal()).normalized();
  const double half_angle = fixed::acos(std::clamp(middle.dot(from.normal()), -1.0, 1.0));
  const double length = chord.norm() * (half_angle > 1e-6 ? half_angle / fixed::sin(half_angle) : 1.0);
  const Vec3 level = chord - chord.dot(middle) * middle;
  const Vec3 along = Eigen::Quaterniond::FromTwoVectors(middle, from.normal()) * level;
  const Vec3 tangent = Eigen::Quaterniond::FromTwoVectors(to.normal(), from.normal()) * to.frame.row(1).transpose();
  const double scale = length / std::max(level.norm(), 1e-12);
  const auto in_plane = [&](const Vec3& v) { return Plane{v.dot(from.frame.row(1)), v.dot(from.frame.row(2))}; };
  return {to_index, length, scale * in_plane(along), in_plane(tangent)};
}

// The steps from each sensor, one sensor after the other.
class Graph {
 public:
  explicit Graph(const BodySensors& skin) : starts_(skin.sensors.size() + 1) {
    std::vector<std::pair<int, int>> edges;
    for (const auto& [a, b] : skin.edges) {
      edges.emplace_back(a, b);
      edges.emplace_back(b, a);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    steps_.reserve(edges.size());
    for (const auto& [from, to] : edges) {
      steps_.push_back(
          step_between(skin.sensors[static_cast<std::size_t>(from)], skin.sensors[static_cast<std::size_t>(to)], to));
      starts_[static_cast<std::size_t>(from) + 1] = steps_.size();
    }
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] = std::max(starts_[i], starts_[i - 1]);
  }

  Span<const Step> from(std::size_t sensor) const {
    return {steps_.data() + starts_[sensor], starts_[sensor + 1] - starts_[sensor]};
  }

 private:
  std::vector<std::size_t> starts_;
  std::vector<Step> steps_;
};

// Walks from one sensor outwards, shortest way first (Dijkstra), adding up the steps on its tangent plane.
class Walk {
 public:
  Walk(const Graph& graph, std::size_t sensors, double reach) : graph_(graph), places_(sensors), reach_(reach) {}

  void from(int source, int first, std::vector<Neighbour>& map) {
    visit(source, {source, 0, {0, 0}, {1, 0}});
    while (!queue_.empty()) {
      std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
      const auto [length, sensor] = queue_.back();
      queue_.pop_back();
      const Place here = places_[static_cast<std::size_t>(sensor)];
      if (length > here.length) continue;  // a shorter way had been found
      if (within_reach(here.offset)) {
        map.push_back({first + sensor, static_cast<float>(here.offset.real()), static_cast<float>(here.offset.imag())});
      }
      for (const Step& step : graph_.from(static_cast<std::size_t>(sensor))) walk(source, here, step);
    }
  }

 private:
  struct Place {
    int source = -1;  // of the walk that came here last
    double length = 0;
    Plane offset{0, 0}, turn{1, 0};
  };

  // Its length says so, and needs to be calculated only where the square cannot tell.
  bool within_reach(const Plane& offset) const {
    constexpr double kRounding = 1e-9;
    const double square = std::norm(offset), limit = reach_ * reach_;
    if (std::abs(square - limit) > kRounding * limit) return square < limit;
    return length_of(offset.real(), offset.imag()) <= reach_;
  }

  void walk(int source, const Place& here, const Step& step) {
    // Ways along the mesh are up to a fifth longer than the straight line on the map.
    const double length = here.length + step.length;
    const Place& there = places_[static_cast<std::size_t>(step.to)];
    if (length > 1.2 * reach_ || (there.source == source && there.length <= length)) return;
    visit(step.to, {source, length, here.offset + step.offset * here.turn, step.turn * here.turn});
  }

  void visit(int sensor, const Place& place) {
    places_[static_cast<std::size_t>(sensor)] = place;
    queue_.emplace_back(place.length, sensor);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
  }

  const Graph& graph_;
  std::vector<Place> places_;
  double reach_;
  std::vector<std::pair<double, int>> queue_;
};

bool nearer(const Neighbour& a, const Neighbour& b) {
  const float to_a = a.x * a.x + a.y * a.y, to_b = b.x * b.x + b.y * b.y;
  return to_a != to_b ? to_a < to_b : a.sensor < b.sensor;
}

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

void Maps::add(const BodySensors& skin, int first, double reach) {
  const Graph graph(skin);
  Walk walk(graph, skin.sensors.size(), reach);
  for (std::size_t i = 0; i < skin.sensors.size(); ++i) {
    const auto begin = static_cast<std::ptrdiff_t>(neighbours_.size());
    walk.from(static_cast<int>(i), first, neighbours_);
    std::sort(neighbours_.begin() + begin, neighbours_.end(), nearer);
    starts_.push_back(neighbours_.size());
    largest_ = std::max(largest_, neighbours_.size() - static_cast<std::size_t>(begin));
  }
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
