#include "senses/touch/maps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstring>
#include <functional>
#include <memory>
#include <utility>

#include "base/functions.h"
#include "base/numbers.h"
#include "base/process.h"

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

  void from(int source, std::vector<Neighbour>& map) {
    visit(source, {source, 0, source, nullptr});
    while (!queue_.empty()) {
      std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
      const auto [length, sensor] = queue_.back();
      queue_.pop_back();
      Place& here = at(sensor);
      if (length > here.length) continue;  // a shorter way had been found
      unroll(here);
      if (within_reach(here.offset)) {
        map.push_back({sensor, static_cast<float>(here.offset.real()), static_cast<float>(here.offset.imag())});
      }
      for (const Step& step : graph_.from(static_cast<std::size_t>(sensor))) walk(source, sensor, length, step);
    }
  }

 private:
  struct Place {
    int source = -1;             // of the walk that came here last
    double length = 0;           // of its shortest way so far
    int before = -1;             // the last sensor of that way
    const Step* step = nullptr;  // from there, null at the source
    Plane offset{0, 0}, turn{1, 0};
  };

  Place& at(int sensor) { return places_[static_cast<std::size_t>(sensor)]; }

  // Once the way is known to be the shortest: most are not.
  void unroll(Place& place) {
    if (place.step == nullptr) return;
    const Place& before = at(place.before);
    place.offset = before.offset + place.step->offset * before.turn;
    place.turn = place.step->turn * before.turn;
  }

  // Its length says so, and needs to be calculated only where the square cannot tell.
  bool within_reach(const Plane& offset) const {
    constexpr double kRounding = 1e-9;
    const double square = std::norm(offset), limit = reach_ * reach_;
    if (std::abs(square - limit) > kRounding * limit) return square < limit;
    return length_of(offset.real(), offset.imag()) <= reach_;
  }

  void walk(int source, int sensor, double so_far, const Step& step) {
    // Ways along the mesh are up to a fifth longer than the straight line on the map.
    const double length = so_far + step.length;
    const Place& there = at(step.to);
    if (length > 1.2 * reach_ || (there.source == source && there.length <= length)) return;
    visit(step.to, {source, length, sensor, &step});
  }

  void visit(int sensor, const Place& place) {
    at(sensor) = place;
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

// What a body's maps follow from, and nothing else.
struct Surroundings {
  std::vector<double> sensors;  // position and frame of each
  std::vector<std::pair<int, int>> edges;
  double reach;

  Surroundings(const BodySensors& skin, double map_reach) : edges(skin.edges), reach(map_reach) {
    for (const Sensor& sensor : skin.sensors) {
      sensors.insert(sensors.end(), sensor.position.data(), sensor.position.data() + sensor.position.size());
      sensors.insert(sensors.end(), sensor.frame.data(), sensor.frame.data() + sensor.frame.size());
    }
  }

  // To the bit: -0 is not 0.
  bool operator==(const Surroundings& other) const {
    return same(sensors, other.sensors) && edges == other.edges && reach == other.reach;
  }

 private:
  static bool same(const std::vector<double>& one, const std::vector<double>& other) {
    return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) == 0;
  }
};

// The maps of a body's sensors, numbered from 0 on, one behind the other.
struct BodyMaps {
  Surroundings of;
  std::vector<std::size_t> ends;
  std::vector<Neighbour> neighbours;

  std::size_t bytes() const {
    return sizeof(double) * of.sensors.size() + sizeof(of.edges[0]) * of.edges.size() + sizeof(ends[0]) * ends.size() +
           sizeof(Neighbour) * neighbours.size();
  }
};

using BodyMapsPtr = std::shared_ptr<const BodyMaps>;

BodyMapsPtr make_maps(const BodySensors& skin, Surroundings&& of) {
  const double reach = of.reach;
  auto maps = std::make_shared<BodyMaps>(BodyMaps{std::move(of), {}, {}});
  const Graph graph(skin);
  Walk walk(graph, skin.sensors.size(), reach);
  for (std::size_t i = 0; i < skin.sensors.size(); ++i) {
    const auto begin = static_cast<std::ptrdiff_t>(maps->neighbours.size());
    walk.from(static_cast<int>(i), maps->neighbours);
    std::sort(maps->neighbours.begin() + begin, maps->neighbours.end(), nearer);
    maps->ends.push_back(maps->neighbours.size());
  }
  maps->neighbours.shrink_to_fit();
  return maps;
}

// Maps are half of the time that making a world takes, and most worlds of a process have the skin of an earlier one. So
// those of the bodies that were asked for last are kept: an infant's skin takes three megabytes.
constexpr std::size_t kMostKeptBytes = 8 << 20;
std::vector<BodyMapsPtr>* kept = nullptr;
std::atomic_flag kept_in_use = ATOMIC_FLAG_INIT;

const AtUnload forget_kept([] { delete std::exchange(kept, nullptr); });

// No thread waits for another, and a child that was forked at the wrong time goes without.
template <typename Use>
void with_kept(Use&& use) {
  if (kept_in_use.test_and_set(std::memory_order_acquire)) return;
  struct Release {
    ~Release() { kept_in_use.clear(std::memory_order_release); }
  } const release;
  watch_the_end();
  if (kept == nullptr) kept = new std::vector<BodyMapsPtr>;
  use(*kept);
}

using Kept = std::vector<BodyMapsPtr>;

// Puts it first.
BodyMapsPtr find(Kept& all, const Surroundings& of) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const BodyMapsPtr& maps) { return maps->of == of; });
  if (at == all.end()) return nullptr;
  std::rotate(all.begin(), at, at + 1);
  return all.front();
}

BodyMapsPtr find_kept(const Surroundings& of) {
  BodyMapsPtr found;
  with_kept([&](Kept& all) { found = find(all, of); });
  return found;
}

// Unless another thread has been quicker, or they are too large.
void keep_too(const BodyMapsPtr& maps) {
  if (maps->bytes() > kMostKeptBytes) return;
  with_kept([&](Kept& all) {
    if (find(all, maps->of) != nullptr) return;
    all.insert(all.begin(), maps);
    std::size_t bytes = 0;
    const auto beyond = [&](const BodyMapsPtr& each) { return (bytes += each->bytes()) > kMostKeptBytes; };
    all.erase(std::find_if(all.begin(), all.end(), beyond), all.end());
  });
}

BodyMapsPtr maps_of(const BodySensors& skin, double reach) {
  Surroundings of(skin, reach);
  if (BodyMapsPtr known = find_kept(of)) return known;
  const BodyMapsPtr maps = make_maps(skin, std::move(of));
  keep_too(maps);
  return maps;
}

}  // namespace

std::size_t kept_map_bytes() {
  std::size_t bytes = 0;
  with_kept([&](Kept& all) {
    for (const BodyMapsPtr& each : all) bytes += each->bytes();
  });
  return bytes;
}

void Maps::add(const BodySensors& skin, int first, double reach) {
  const BodyMapsPtr maps = maps_of(skin, reach);
  const std::size_t begin = neighbours_.size();
  neighbours_.reserve(begin + maps->neighbours.size());
  for (const Neighbour& each : maps->neighbours) neighbours_.push_back({first + each.sensor, each.x, each.y});
  for (const std::size_t end : maps->ends) {
    largest_ = std::max(largest_, begin + end - starts_.back());
    starts_.push_back(begin + end);
  }
}

}  // namespace mimo::senses::touch
