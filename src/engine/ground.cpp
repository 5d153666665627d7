#include "engine/ground.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/length.h"
#include "compat/mujoco.h"
#include "engine/schema.h"

namespace mimo::engine {
namespace {

bool can_touch(const mjModel& model, int one, int other) {
  return ((model.geom_contype[one] & model.geom_conaffinity[other]) |
          (model.geom_contype[other] & model.geom_conaffinity[one])) != 0;
}

bool stands_still(const mjModel& model, int geom) { return model.body_weldid[model.geom_bodyid[geom]] == 0; }

// Distance downwards from a point to a geom; negative where it is not met.
double distance_below(const mjModel& model, const mjData& data, int geom, const Eigen::Vector3d& point) {
  const Eigen::Vector3d down(0, 0, -1);
  switch (model.geom_type[geom]) {
    case mjGEOM_MESH: return compat::ray_mesh(model, data, geom, point.data(), down.data());
    case mjGEOM_HFIELD: return compat::ray_field(model, data, geom, point.data(), down.data());
    default: return compat::ray_shape(model, data, geom, point.data(), down.data());
  }
}

// Whether a face of a box looks in a direction, or away from it.
bool has_face(const mjData& data, int box, const Eigen::Vector3d& direction) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> frame(data.geom_xmat + 9 * box);
  return (frame.transpose() * direction).cwiseAbs().maxCoeff() > 1 - 1e-9;
}

}  // namespace

double half_height(const mjModel& model, const mjData& data, int geom) {
  const double* size = model.geom_size + 3 * geom;
  const double* z = data.geom_xmat + 9 * geom + 6;  // the world's z axis in the geom's frame
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE: return size[0];
    case mjGEOM_CAPSULE: return size[0] + std::abs(z[2]) * size[1];
    case mjGEOM_CYLINDER: return size[0] * length_of(z[0], z[1]) + size[1] * std::abs(z[2]);
    case mjGEOM_BOX: return size[0] * std::abs(z[0]) + size[1] * std::abs(z[1]) + size[2] * std::abs(z[2]);
    case mjGEOM_ELLIPSOID: return length_of(size[0] * z[0], size[1] * z[1], size[2] * z[2]);
    default: return model.geom_rbound[geom];
  }
}

std::vector<int> geoms_of_tree(const mjModel& model, int root) {
  std::vector<int> geoms;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.body_rootid[model.geom_bodyid[geom]] == root) geoms.push_back(geom);
  }
  return geoms;
}

std::vector<double> heights_at(const mjModel& model, const mjData& data, const std::vector<int>& geoms, double x,
                               double y) {
  constexpr double kAbove = 1000, kBeyond = 1e-6;  // m
  constexpr int kMost = 16;                        // a closed mesh is met again and again
  std::vector<double> heights;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool matters = stands_still(model, geom) && std::any_of(geoms.begin(), geoms.end(), [&](int own) {
                           return own != geom && can_touch(model, own, geom);
                         });
    if (!matters) continue;
    Eigen::Vector3d point(x, y, data.geom_xpos[3 * geom + 2] + model.geom_rbound[geom] + kAbove);
    for (int i = 0; i < kMost; ++i) {
      const double distance = distance_below(model, data, geom, point);
      if (!(distance >= 0)) break;
      point[2] -= distance;
      heights.push_back(point[2]);
      point[2] -= kBeyond;
    }
  }
  return heights;
}

double overlap_of(const mjModel& model, const mjData& data, const Meeting& met) {
  const mjContact& contact = data.contact[met.number];
  if (!is_mujoco_2() || !met.is_of_geoms()) return -contact.dist;
  const auto [one, other] = met.geoms;
  if (model.geom_type[one] != mjGEOM_BOX || model.geom_type[other] != mjGEOM_BOX) return -contact.dist;
  const Eigen::Vector3d normal(contact.frame);
  return has_face(data, one, normal) || has_face(data, other, normal) ? -2 * contact.dist : -contact.dist;
}

Overlap deepest_overlap(const mjModel& model, const mjData& data, int root) {
  Overlap deepest;
  for (const Meeting& met : Contacts(model, data)) {
    const bool first = model.body_rootid[met.bodies[0]] == root, second = model.body_rootid[met.bodies[1]] == root;
    if (first == second || data.contact[met.number].dist >= 0) continue;
    const double depth = overlap_of(model, data, met);
    if (depth <= deepest.depth) continue;
    deepest = {depth, met, first ? 0U : 1U};
  }
  return deepest;
}

}  // namespace mimo::engine
