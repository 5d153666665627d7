#include "engine/contacts.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fail.h"
#include "base/numbers.h"
#include "compat/mujoco.h"
#include "engine/compiler.h"

namespace mimo::engine {

#if MIMO_MUJOCO_4

namespace {

using Vec3 = Eigen::Vector3d;

// Keeps the body of the nearest of some places.
class Nearest {
 public:
  explicit Nearest(const double* to) : to_(to) {}
  void look_at(const Vec3& place, int body) {
    const double distance = (place - to_).squaredNorm();
    if (!(distance < least_)) return;
    least_ = distance;
    body_ = body;
  }
  int body() const { return body_; }

 private:
  Vec3 to_;
  double least_ = std::numeric_limits<double>::infinity();
  int body_ = -1;
};

int body_of_nodes(const mjModel& model, const mjData& data, int flex, const double* point) {
  Nearest nearest(point);
  for (int i = model.flex_nodeadr[flex]; i < model.flex_nodeadr[flex] + model.flex_nodenum[flex]; ++i) {
    const int body = model.flex_nodebodyid[i];
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(data.xmat + 9 * body);
    nearest.look_at(Vec3(data.xpos + 3 * body) + rotation * Vec3(model.flex_node + 3 * i), body);
  }
  return nearest.body();
}

bool moves_with_nodes(const mjModel& model, int flex) { return model.flex_interp[flex] != 0; }

// Whether all that moves it is among the wanted.
bool hangs_on(const mjModel& model, int flex, const std::vector<bool>& wanted) {
  const bool nodes = moves_with_nodes(model, flex);
  const int first = nodes ? model.flex_nodeadr[flex] : model.flex_vertadr[flex];
  const int count = nodes ? model.flex_nodenum[flex] : model.flex_vertnum[flex];
  const int* const bodies = (nodes ? model.flex_nodebodyid : model.flex_vertbodyid) + first;
  return std::all_of(bodies, bodies + count, [&](int body) { return wanted[static_cast<std::size_t>(body)]; });
}

}  // namespace

int flex_count(const mjModel& model) { return static_cast<int>(model.nflex); }

std::vector<int> flexes_on(const mjModel& model, const std::vector<int>& bodies) {
  std::vector<bool> wanted(static_cast<std::size_t>(model.nbody));
  for (const int body : bodies) wanted[static_cast<std::size_t>(body)] = true;
  std::vector<int> flexes;
  for (int i = 0; i < model.nflex; ++i) {
    if (hangs_on(model, i, wanted)) flexes.push_back(i);
  }
  return flexes;
}

std::array<int, 2> flexes_of(const mjContact& contact) { return {contact.flex[0], contact.flex[1]}; }

int body_of_flex(const mjModel& model, const mjData& data, const mjContact& contact, std::size_t side) {
  const int flex = contact.flex[side], element = contact.elem[side], vertex = contact.vert[side];
  if (flex < 0 || flex >= model.nflex) return -1;
  if (moves_with_nodes(model, flex)) return body_of_nodes(model, data, flex, contact.pos);
  const int first = model.flex_vertadr[flex];
  if (vertex >= 0 && vertex < model.flex_vertnum[flex]) return model.flex_vertbodyid[first + vertex];
  if (element < 0 || element >= model.flex_elemnum[flex]) return -1;
  const int corners = model.flex_dim[flex] + 1;
  const int* const corner = model.flex_elem + model.flex_elemdataadr[flex] + element * corners;
  Nearest nearest(contact.pos);
  for (int i = 0; i < corners; ++i) {
    const int at = first + corner[i];
    nearest.look_at(Vec3(data.flexvert_xpos + 3 * at), model.flex_vertbodyid[at]);
  }
  return nearest.body();
}

void require_told_forces(const mjModel& model) {
  const bool by_potential = (model.opt.enableflags & mjENBL_IPC) != 0;
  for (int i = 0; i < model.nflex; ++i) {
    const char* const name = model.names + model.name_flexadr[i];
    if (by_potential) {
      fail(Status::kUnsupported,
           "flex {} (\"{}\"): with the flag ipc MuJoCo does not report the forces of its contacts, which touch and "
           "reflexes need; switch off the flag, or touch and reflexes",
           i, name);
    }
    if (model.flex_passive[i] == 0) continue;
    fail(Status::kUnsupported,
         "flex {} (\"{}\") has passive contacts, whose forces MuJoCo does not report; touch and reflexes need them; "
         "leave "
         "out its attribute passive, or switch touch and reflexes off",
         i, name);
  }
}

#else

int flex_count(const mjModel&) { return 0; }
std::vector<int> flexes_on(const mjModel&, const std::vector<int>&) { return {}; }
std::array<int, 2> flexes_of(const mjContact&) { return {-1, -1}; }
int body_of_flex(const mjModel&, const mjData&, const mjContact&, std::size_t) { return -1; }
void require_told_forces(const mjModel&) {}

#endif

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
