#include "engine/flexes.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "base/fail.h"
#include "compat/mujoco.h"

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
           "flex {} (\"{}\"): with the flag ipc MuJoCo tells no forces of its contacts, which touch and reflexes need; "
           "switch the flag off, or touch and reflexes",
           i, name);
    }
    if (model.flex_passive[i] == 0) continue;
    fail(Status::kUnsupported,
         "flex {} (\"{}\") has passive contacts, of which MuJoCo tells no forces, which touch and reflexes need; leave "
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

}  // namespace mimo::engine
