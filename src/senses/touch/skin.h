// The skin of an infant: all its sensors, and what is needed to tell who feels a touch. Immutable once made.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/span.h"
#include "engine/contacts.h"
#include "senses/touch/maps.h"
#include "senses/touch/sensors.h"
#include "senses/touch/shape.h"

namespace mimo::senses::touch {

// A k-d tree of points: which one is nearest, which ones are near. Queries allocate nothing.

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

struct BodySpacing {
  int body;
  double spacing;  // m
};

class Skin {
 public:
  // Spacings are those at 18 months. Throws Status::kInvalidArgument when that makes more sensors than fit the memory.
  Skin(const mjModel& model, const std::vector<BodySpacing>& bodies, const BornGeoms& born = {});

  // Bodies in the order given, their geoms by id.
  const std::vector<Sensor>& sensors() const { return sensors_; }

  bool covers(int body) const { return part_of_body_[static_cast<std::size_t>(body)] != kNone; }
  // A side of a contact; no flex has skin.
  bool covers(const engine::Meeting& met, std::size_t side) const {
    return met.geoms[side] >= 0 && covers(met.bodies[side]);
  }
  // How far apart sensors are now.
  double spacing(int body) const { return part(body).spacing; }

  // The sensor of a geom that is nearest to a point (body frame); of the body where the geom has none.
  int nearest(int geom, const Vec3& point) const;
  // The nearest sensor of the whole body.
  int nearest_of_body(int body, const Vec3& point) const;
  // The surroundings of a sensor, up to three times its spacing away.
  const Maps& maps() const { return maps_; }

 private:
  static constexpr int kNone = -1;
  struct Part {
    double spacing;
    std::vector<int> geoms;
  };

  void add(const mjModel& model, const BodySpacing& body, const BornGeoms& born);
  const Part& part(int body) const {
    return parts_[static_cast<std::size_t>(part_of_body_[static_cast<std::size_t>(body)])];
  }

  std::vector<Sensor> sensors_;
  std::vector<Part> parts_;
  std::vector<int> part_of_body_;
  std::vector<int> body_of_geom_;
  std::vector<PointTree> trees_;  // by geom
  Maps maps_;
};

}  // namespace mimo::senses::touch
