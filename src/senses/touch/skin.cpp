#include "senses/touch/skin.h"

#include "base/fail.h"

namespace mimo::senses::touch {
namespace {

constexpr double kMaxSensors = 1e6;

// A contact lies up to a cell from the nearest sensor and reaches two spacings from there.
constexpr double kMapReach = 3;

}  // namespace

Skin::Skin(const mjModel& model, const std::vector<BodySpacing>& bodies, const BornGeoms& born)
    : part_of_body_(static_cast<std::size_t>(model.nbody), kNone),
      body_of_geom_(model.geom_bodyid, model.geom_bodyid + model.ngeom),
      trees_(static_cast<std::size_t>(model.ngeom)) {
  double expected = 0;
  for (const BodySpacing& body : bodies) {
    expected += expected_sensors(model, body.body, body.spacing, born);
    require(expected <= kMaxSensors,
            "touch: {:g} m between the sensors of body \"{}\" makes too many: about {:.3g}, at most {:g}", body.spacing,
            engine::name(model, engine::Kind::kBody, body.body), expected, kMaxSensors);
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
