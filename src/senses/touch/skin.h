// The skin of an infant: all its sensors, and what is needed to tell who feels a touch. Immutable once made.
#pragma once

#include <vector>

#include "engine/contacts.h"
#include "senses/touch/point_tree.h"
#include "senses/touch/sensors.h"
#include "senses/touch/unfold.h"

namespace mimo::senses::touch {

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
