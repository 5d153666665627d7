#include "senses/touch/born.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/names.h"
#include "engine/custom.h"
#include "senses/touch/surface.h"

namespace mimo::senses::touch {
namespace {

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
Vec3 moved(const Shape& from, const Shape& to, const Vec3& point) {
  if (from.form == Shape::Form::kBox) return point.cwiseProduct(to.size).cwiseQuotient(from.size);
  const double radial = to.size.x() / from.size.x();
  if (from.form == Shape::Form::kSphere) return radial * point;
  const double along = to.size.y() / from.size.y();
  const double side = std::clamp(point.z(), -from.size.y(), from.size.y());
  return {radial * point.x(), radial * point.y(), along * side + radial * (point.z() - side)};
}

}  // namespace

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
    fail(Status::kModel, "numeric {}: a size of geom \"{}\" is not above 0, or its place is no number", name,
         engine::name(model, engine::Kind::kGeom, geom));
  }
}

bool BornGeoms::knows(int geom) const { return any() && !sizes_[static_cast<std::size_t>(geom)].isZero(0); }

Shape BornGeoms::shape(const mjModel& model, int geom) const {
  Shape shape = shape_of(model, geom);
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
