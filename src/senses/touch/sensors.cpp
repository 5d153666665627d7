#include "senses/touch/sensors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/names.h"
#include "engine/model.h"
#include "senses/touch/skin.h"
#include "senses/touch/surface.h"

namespace mimo::senses::touch {
namespace {

// One geom of a body and the points on it.
struct Part {
  int geom;
  OuterShape shape;
  Eigen::Matrix3d rotation;  // geom frame to body frame
  Vec3 place;                // of the geom in the body
  Surface surface;
  int first = 0, end = 0;  // its sensors

  Vec3 in_body(const Vec3& point) const { return rotation * point + place; }
  bool contains(const Vec3& in_body) const { return inside(shape, rotation.transpose() * (in_body - place)); }
};

std::vector<Part> parts_of(const mjModel& model, int body, double spacing, const BornGeoms& born) {
  std::vector<Part> parts;
  for (const int geom : geoms_with_skin(model, body)) {
    const OuterShape shape = born.shape(model, geom);
    parts.push_back({geom, shape, rotation_of(model, geom), born.place(model, geom), sample(shape, spacing), 0, 0});
  }
  return parts;
}

// Inside another geom of the body. One that is itself a single point hides nothing.
bool buried(const std::vector<Part>& parts, const Part& own, const Vec3& point) {
  return std::any_of(parts.begin(), parts.end(), [&](const Part& other) {
    return &other != &own && !other.surface.single() && other.contains(point);
  });
}

// The skin's own directions at a point (see docs/guide/touch.md).
Eigen::Matrix3d skin_frame(const Vec3& normal) {
  const double kNearlyAlong = 0.984807753012208;  // cosine of 10 degrees
  const Vec3 along = std::abs(normal.x()) > kNearlyAlong ? Vec3::UnitY() : Vec3::UnitX();
  const Vec3 first = (along - along.dot(normal) * normal).normalized();
  Eigen::Matrix3d frame;
  frame << normal.transpose(), first.transpose(), normal.cross(first).transpose();
  return frame;
}

void add_part(const std::vector<Part>& parts, Part& part, int body, BodySensors& skin) {
  part.first = static_cast<int>(skin.sensors.size());
  constexpr int kBuried = -1;
  std::vector<int> index(part.surface.points.size(), kBuried);
  for (std::size_t i = 0; i < index.size(); ++i) {
    const SurfacePoint& point = part.surface.points[i];
    const Vec3 position = part.in_body(point.position);
    if (buried(parts, part, position)) continue;
    // The middle of a geom has no outside; it counts as looking ahead.
    const Vec3 normal = part.surface.single() ? Vec3::UnitX() : Vec3((part.rotation * point.normal).normalized());
    index[i] = static_cast<int>(skin.sensors.size());
    skin.sensors.push_back({body, part.geom, position, skin_frame(normal)});
  }
  part.end = static_cast<int>(skin.sensors.size());
  for (const auto& [from, to] : part.surface.edges) {
    const int a = index[static_cast<std::size_t>(from)], b = index[static_cast<std::size_t>(to)];
    if (a != kBuried && b != kBuried && a != b) skin.edges.emplace_back(a, b);
  }
}

// Across the seam where the surfaces of two geoms meet. Sensors there lie up to a cell from the seam on either side,
// and look the same way or at a right angle to each other; the two sides of a thin part look opposite ways.
class Seams {
 public:
  Seams(BodySensors& skin, double spacing) : skin_(skin), reach_(2.5 * spacing) {}

  void link(int sensor, const PointTree& other) {
    near_.clear();
    const Sensor& own = skin_.sensors[static_cast<std::size_t>(sensor)];
    other.within(own.position, reach_, [&](int id, double square) {
      const Sensor& candidate = skin_.sensors[static_cast<std::size_t>(id)];
      if (own.normal().dot(candidate.normal()) > -0.1) near_.emplace_back(square, id);
    });
    const std::size_t links = std::min<std::size_t>(near_.size(), 3);
    std::partial_sort(near_.begin(), near_.begin() + static_cast<std::ptrdiff_t>(links), near_.end());
    for (std::size_t i = 0; i < links; ++i) skin_.edges.emplace_back(sensor, near_[i].second);
  }

 private:
  BodySensors& skin_;
  double reach_;
  std::vector<std::pair<double, int>> near_;
};

void link_parts(const std::vector<Part>& parts, double spacing, BodySensors& skin) {
  Seams seams(skin, spacing);
  for (const Part& part : parts) {
    std::vector<Vec3> points;
    for (int i = part.first; i < part.end; ++i) points.push_back(skin.sensors[static_cast<std::size_t>(i)].position);
    const PointTree tree(points, part.first);
    for (const Part& other : parts) {
      if (&other == &part || other.surface.single() || part.surface.single()) continue;
      for (int i = other.first; i < other.end; ++i) seams.link(i, tree);
    }
  }
}

std::vector<int> geoms_of(const mjModel& model, const body::Body& body) {
  std::vector<int> geoms;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (body.has(model.geom_bodyid[geom])) geoms.push_back(geom);
  }
  return geoms;
}

// Three numbers for each of some geoms, by geom.
std::vector<Vec3> triples(const mjModel& model, const std::string& name, const std::vector<int>& geoms) {
  const Span<const double> numbers = engine::custom_numbers(model, name);
  if (numbers.size() != 3 * geoms.size()) {
    fail(Status::kModel, "numeric {} has {} numbers, expected three for each of the infant's {} geoms", name,
         numbers.size(), geoms.size());
  }
  std::vector<Vec3> all(static_cast<std::size_t>(model.ngeom), Vec3::Zero());
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    all[static_cast<std::size_t>(geoms[i])] = Vec3(numbers.data() + 3 * i);
  }
  return all;
}

// How many of its three sizes count; 0: no infant has such a geom, and it does not grow.
Eigen::Index size_count(const mjModel& model, int geom) {
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE: return 1;
    case mjGEOM_CAPSULE:
    case mjGEOM_CYLINDER: return 2;
    case mjGEOM_BOX: return 3;
    default: return 0;
  }
}

// In the geom's frame. Caps of a capsule stay half spheres.
Vec3 moved(const OuterShape& from, const OuterShape& to, const Vec3& point) {
  if (from.form == OuterShape::Form::kBox) return point.cwiseProduct(to.size).cwiseQuotient(from.size);
  const double radial = to.size.x() / from.size.x();
  if (from.form == OuterShape::Form::kSphere) return radial * point;
  const double along = to.size.y() / from.size.y();
  const double side = std::clamp(point.z(), -from.size.y(), from.size.y());
  return {radial * point.x(), radial * point.y(), along * side + radial * (point.z() - side)};
}

}  // namespace

std::vector<int> geoms_with_skin(const mjModel& model, int body) {
  std::vector<int> geoms;
  for (int geom = model.body_geomadr[body]; geom < model.body_geomadr[body] + model.body_geomnum[body]; ++geom) {
    const bool can_touch = (model.geom_contype[geom] | model.geom_conaffinity[geom]) != 0;
    if (can_touch && has_shape(model, geom)) geoms.push_back(geom);
  }
  return geoms;
}

double expected_sensors(const mjModel& model, int body, double spacing, const BornGeoms& born) {
  double sum = 0;
  for (const int geom : geoms_with_skin(model, body)) sum += expected_points(born.shape(model, geom), spacing);
  return sum;
}

BodySensors place_sensors(const mjModel& model, int body, double spacing, const BornGeoms& born) {
  std::vector<Part> parts = parts_of(model, body, spacing, born);
  BodySensors skin;
  for (Part& part : parts) add_part(parts, part, body, skin);
  if (parts.size() > 1) link_parts(parts, spacing, skin);
  for (Sensor& sensor : skin.sensors) sensor.position = born.grown(model, sensor.geom, sensor.position);
  return skin;
}

BornGeoms::BornGeoms(const mjModel& model, const body::Body& body) {
  const std::string name = body.prefix + names::kBornSizes;
  if (engine::custom_numbers(model, name).empty()) return;
  const std::vector<int> geoms = geoms_of(model, body);
  sizes_ = triples(model, name, geoms);
  places_ = triples(model, body.prefix + names::kBornPlaces, geoms);
  for (const int geom : geoms) {
    Vec3& size = sizes_[static_cast<std::size_t>(geom)];
    const Eigen::Index count = size_count(model, geom);
    if (count == 0) size.setZero();
    const bool fits = size.allFinite() && (size.head(count).array() > 0).all();
    if (fits && places_[static_cast<std::size_t>(geom)].allFinite()) continue;
    fail(Status::kModel, "numeric {}: a size of geom \"{}\" is not above 0, or its position is not a number", name,
         engine::name(model, engine::Kind::kGeom, geom));
  }
}

bool BornGeoms::knows(int geom) const { return any() && !sizes_[static_cast<std::size_t>(geom)].isZero(0); }

OuterShape BornGeoms::shape(const mjModel& model, int geom) const {
  OuterShape shape = shape_of(model, geom);
  if (knows(geom)) shape.size = sizes_[static_cast<std::size_t>(geom)];
  return shape;
}

Vec3 BornGeoms::place(const mjModel& model, int geom) const {
  return knows(geom) ? places_[static_cast<std::size_t>(geom)] : Vec3(model.geom_pos + 3 * geom);
}

Vec3 BornGeoms::grown(const mjModel& model, int geom, const Vec3& point) const {
  if (!knows(geom)) return point;
  const Eigen::Matrix3d rotation = rotation_of(model, geom);
  const Vec3 own = rotation.transpose() * (point - place(model, geom));
  return rotation * moved(shape(model, geom), shape_of(model, geom), own) + Vec3(model.geom_pos + 3 * geom);
}

double BornGeoms::stretch(const mjModel& model, const std::vector<int>& geoms) const {
  if (!any()) return 1;
  double was = 0, is = 0;
  for (const int geom : geoms) {
    was += area(shape(model, geom));
    is += area(shape_of(model, geom));
  }
  return std::sqrt(is / was);
}

}  // namespace mimo::senses::touch
