#include "senses/touch/unfold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>

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
  const double half_angle = std::acos(std::clamp(middle.dot(from.normal()), -1.0, 1.0));
  const double length = chord.norm() * (half_angle > 1e-6 ? half_angle / std::sin(half_angle) : 1.0);
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
    return std::abs(offset) <= reach_;
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

}  // namespace

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

}  // namespace mimo::senses::touch
