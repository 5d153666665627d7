#include "body/nerves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <string_view>

#include "base/names.h"

namespace mimo::body {
namespace {

using Eigen::Vector3d;

// Nerves over the straight ways from joint to joint, by where they run. Fitted to the ways that evoked potentials are
// explained by (a newborn's wrist 0.257 m from its neck) and to lengths of infants' limbs: this body's limbs are
// shorter between their joints than what is measured on infants, and its hips lie lower.
constexpr double kHead = 1.03;
constexpr double kArm = 1.37;  // from the hand to the neck
constexpr double kSpine = 0.62;
constexpr double kLeg = 1.65;  // from the toes to the hip

Vector3d middle(const mjModel& model, int body) { return Vector3d(model.body_ipos + 3 * body); }

// Where a body hangs on its parent, in its own frame: its first joint, or its origin where nothing turns.
Vector3d anchor(const mjModel& model, int body) {
  if (model.body_jntnum[body] == 0) return Vector3d::Zero();
  return Vector3d(model.jnt_pos + 3 * model.body_jntadr[body]);
}

Vector3d in_parent(const mjModel& model, int body, const Vector3d& point) {
  const double* q = model.body_quat + 4 * body;
  return Vector3d(model.body_pos + 3 * body) + Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * point;
}

// The bodies from the head to the root of the infant.
std::vector<int> spine(const mjModel& model, int head, int root) {
  std::vector<int> bodies;
  for (int at = head; at != root; at = model.body_parentid[at]) bodies.push_back(at);
  bodies.push_back(root);
  return bodies;
}

// The root of the infant that a body is part of; 0 for none.
int root_of(const mjModel& model, int body) {
  const std::string_view name = names::kRootBody;
  for (; body > 0; body = model.body_parentid[body]) {
    const std::string_view its = engine::name(model, engine::Kind::kBody, body);
    if (its.size() >= name.size() && its.substr(its.size() - name.size()) == name) return body;
  }
  return 0;
}

// From a point of the spine's i-th body up to the base of the neck.
double up_the_spine(const mjModel& model, const std::vector<int>& spine, std::size_t i, Vector3d point) {
  double length = 0;
  for (; i > 0; --i) {
    const Vector3d next = in_parent(model, spine[i - 1], anchor(model, spine[i - 1]));
    length += (next - point).norm();
    point = anchor(model, spine[i - 1]);
  }
  return length;
}

double length_from(const mjModel& model, const std::vector<int>& spine, int body) {
  Vector3d point = middle(model, body);
  double limb = 0;
  int at = body;
  auto reached = std::find(spine.begin(), spine.end(), at);
  while (reached == spine.end()) {
    limb += (anchor(model, at) - point).norm();
    point = in_parent(model, at, anchor(model, at));
    at = model.body_parentid[at];
    reached = std::find(spine.begin(), spine.end(), at);
  }
  const Vector3d neck = anchor(model, spine[0]);
  if (reached == spine.begin()) return kHead * (limb + (point - neck).norm());  // in the head
  const double head = kHead * (middle(model, spine[0]) - neck).norm();
  const double trunk = up_the_spine(model, spine, static_cast<std::size_t>(reached - spine.begin()), point);
  // Arms hang on what carries the head.
  const bool arm = at != body && reached == spine.begin() + 1;
  return (arm ? kArm * (limb + trunk) : kLeg * limb + kSpine * trunk) + head;
}

}  // namespace

std::vector<double> nerve_lengths(const mjModel& model, const Body& body) {
  std::vector<double> lengths(static_cast<std::size_t>(model.nbody), 0.0);
  if (body.head < 0) return lengths;
  const std::vector<int> way = spine(model, body.head, body.root);
  for (const int id : body.bodies) lengths[static_cast<std::size_t>(id)] = length_from(model, way, id);
  return lengths;
}

double nerve_length(const mjModel& model, int body) {
  const int root = root_of(model, body);
  if (root == 0) return 0;
  std::string name = engine::name(model, engine::Kind::kBody, root);
  name.replace(name.size() - std::string_view(names::kRootBody).size(), std::string::npos, "head");
  const int head = engine::find(model, engine::Kind::kBody, name.c_str());
  return head < 0 ? 0 : length_from(model, spine(model, head, root), body);
}

}  // namespace mimo::body
