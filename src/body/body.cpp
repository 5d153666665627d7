#include "body/body.h"

#include <mujoco/mjmodel.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"
#include "engine/contacts.h"
#include "engine/model.h"

namespace mimo::body {
namespace {

using engine::Kind;

std::vector<int> ids_with_prefix(const mjModel& model, Kind kind, const std::string& prefix) {
  std::vector<int> ids;
  for (int id = 0; id < engine::count(model, kind); ++id) {
    if (begins_with(engine::name(model, kind, id), prefix)) ids.push_back(id);
  }
  return ids;
}

Joint hinge(const mjModel& model, int id) {
  if (model.jnt_type[id] != mjJNT_HINGE) {
    fail(Status::kModel, "joint {} is not a hinge", engine::name(model, Kind::kJoint, id));
  }
  return joint(model, id);
}

std::optional<Sensor> find_sensor(const mjModel& model, const std::string& name) {
  const int id = engine::find(model, Kind::kSensor, name.c_str());
  if (id < 0) return std::nullopt;
  return sensor(model, id);
}

// What the document says of how it has grown.
void read_growth(const mjModel& model, Body& body) {
  const std::string name = body.prefix + names::kGrowth;
  const Span<const double> numbers = engine::custom_numbers(model, name);
  if (numbers.empty()) return;
  if (numbers.size() != 3 || !(numbers[1] > 0 && numbers[2] > 0) || !std::isfinite(numbers[1] + numbers[2])) {
    fail(Status::kModel, "numeric {}: expected three numbers, age, and stature and arms as factors above 0", name);
  }
  body.stature = numbers[1];
  body.arm = numbers[2];
}

using engine::Kind;

// The body that an actuator works on first of all; -1 for one whose tendon leads nowhere.
int body_of_tendon(const mjModel& model, int tendon) {
  for (int i = model.tendon_adr[tendon]; i < model.tendon_adr[tendon] + model.tendon_num[tendon]; ++i) {
    const int object = model.wrap_objid[i];
    if (model.wrap_type[i] == mjWRAP_JOINT) return model.jnt_bodyid[object];
    if (model.wrap_type[i] == mjWRAP_SITE) return model.site_bodyid[object];
  }
  return -1;
}

int body_of_actuator(const mjModel& model, int actuator) {
  const int target = model.actuator_trnid[2 * actuator];
  switch (model.actuator_trntype[actuator]) {
    case mjTRN_JOINT:
    case mjTRN_JOINTINPARENT: return model.jnt_bodyid[target];
    case mjTRN_SLIDERCRANK:
    case mjTRN_SITE: return model.site_bodyid[target];
    case mjTRN_TENDON: return body_of_tendon(model, target);
    case mjTRN_BODY: return target;
    default: return -1;
  }
}

// Which of the body's hinges a joint is, and how many there are.
struct Place {
  std::size_t number, of;
};

Place place_of(const mjModel& model, const Body& body, int joint) {
  Place place{0, 0};
  for (int id = 0; id < model.njnt; ++id) {
    if (model.jnt_type[id] != mjJNT_HINGE || !body.has(model.jnt_bodyid[id])) continue;
    if (id < joint) ++place.number;
    ++place.of;
  }
  return place;
}

// Calls visit(name, prefix) for each of the names that is `what`, with or without a prefix.
template <typename Visit>
void visit_named(const std::vector<std::string>& names, const std::string& what, Visit&& visit) {
  for (const std::string& name : names) {
    if (name.size() < what.size() || name.compare(name.size() - what.size(), what.size(), what) != 0) continue;
    const std::string prefix = name.substr(0, name.size() - what.size());
    if (prefix.empty() || prefix.back() == '/') visit(name, prefix);
  }
}

void place_root(const mjModel& model, int body, Span<const double> pose, Span<double> qpos) {
  double* start = &qpos[static_cast<std::size_t>(engine::free_joint_address(model, body))];
  std::copy(pose.begin(), pose.end(), start);
  engine::normalize_quaternion(start + 3);
}

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

Joint joint(const mjModel& model, int id) {
  Joint joint{id, model.jnt_qposadr[id], model.jnt_dofadr[id]};
  const bool limited = model.jnt_limited[id] != 0;
  const double endless = std::numeric_limits<double>::infinity();
  joint.low = limited ? model.jnt_range[2 * id] : -endless;
  joint.high = limited ? model.jnt_range[2 * id + 1] : endless;
  return joint;
}

Sensor sensor(const mjModel& model, int id) { return {id, model.sensor_adr[id], model.sensor_dim[id]}; }

bool Body::has(int body) const { return std::binary_search(bodies.begin(), bodies.end(), body); }

std::vector<int> subtree(const mjModel& model, int root) {
  std::vector<int> bodies;
  for (int body = root; body < model.nbody; ++body) {
    int ancestor = body;
    while (ancestor > root) ancestor = model.body_parentid[ancestor];
    if (ancestor == root) bodies.push_back(body);
  }
  return bodies;
}

std::vector<int> bodies_with_skin(const mjModel& model, const Body& body) {
  std::vector<int> bodies;
  for (const auto& entry : engine::custom_tuple(model, body.prefix + names::kTouch, Kind::kBody)) {
    bodies.push_back(entry.id);
  }
  if (bodies.empty()) {
    std::copy_if(body.bodies.begin(), body.bodies.end(), std::back_inserter(bodies),
                 [&](int id) { return model.body_geomnum[id] > 0; });
  }
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

std::vector<int> right_fingers(const mjModel& model, const Body& body) {
  std::vector<int> bodies = subtree(model, engine::find_or_fail(model, Kind::kBody, body.prefix + "right_hand"));
  bodies.erase(bodies.begin());  // the hand itself
  if (bodies.empty()) fail(Status::kNotFound, "body {}right_hand has no fingers", body.prefix);
  return bodies;
}

std::string short_name(const mjModel& model, const Body& body, int id) {
  return std::string(engine::name(model, engine::Kind::kBody, id)).substr(body.prefix.size());
}

Body find_body(const mjModel& model, const std::string& prefix) {
  Body body;
  body.prefix = prefix;
  body.root = engine::find_or_fail(model, Kind::kBody, prefix + names::kRootBody);
  body.head = engine::find_or_fail(model, Kind::kBody, prefix + "head");
  body.bodies = subtree(model, body.root);
  for (const int id : ids_with_prefix(model, Kind::kJoint, prefix + names::kJoint))
    body.joints.push_back(hinge(model, id));
  body.actuators = ids_with_prefix(model, Kind::kActuator, prefix + names::kMotor);
  for (const int id : ids_with_prefix(model, Kind::kSensor, prefix + names::kSensor)) {
    body.torques.push_back(sensor(model, id));
  }
  body.accelerometer = find_sensor(model, prefix + "vestibular_acc");
  body.gyroscope = find_sensor(model, prefix + "vestibular_gyro");
  body.eye_left = engine::find(model, Kind::kCamera, (prefix + "eye_left").c_str());
  body.eye_right = engine::find(model, Kind::kCamera, (prefix + "eye_right").c_str());
  read_growth(model, body);
  return body;
}

std::vector<Motor> motors(const mjModel& model, const Body& body) {
  std::vector<Motor> motors;
  for (const int id : body.actuators) {
    if (model.actuator_trntype[id] != mjTRN_JOINT) {
      fail(Status::kUnsupported, "{} does not turn a joint", engine::name(model, Kind::kActuator, id));
    }
    const int turned = model.actuator_trnid[2 * id];
    if (!engine::has_one_axis(model, turned)) {
      fail(Status::kUnsupported, "{} turns joint {}, which has more than one axis",
           engine::name(model, Kind::kActuator, id), engine::name(model, Kind::kJoint, turned));
    }
    motors.push_back({id, joint(model, turned), engine::find_lock(model, turned)});
  }
  return motors;
}

Units units_of(const mjModel& model, const std::vector<Joint>& joints) {
  const auto slides = [&](const Joint& joint) { return model.jnt_type[joint.id] == mjJNT_SLIDE; };
  if (std::none_of(joints.begin(), joints.end(), slides)) return {"rad", "rad/s", "Nm"};
  if (std::all_of(joints.begin(), joints.end(), slides)) return {"m", "m/s", "N"};
  return {"rad or m", "rad/s or m/s", "Nm or N"};
}

int moved_by(const mjModel& model, int actuator) {
  const int kind = model.actuator_trntype[actuator];
  if (kind != mjTRN_JOINT && kind != mjTRN_JOINTINPARENT) return 0;
  return model.jnt_bodyid[model.actuator_trnid[2 * actuator]];
}

double mass(const mjModel& model, const Body& body) { return model.body_subtreemass[body.root]; }

Extent extent(const mjModel& model, const mjData& data, const Body& body) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const int id : body.bodies) {
    for (int geom = model.body_geomadr[id]; geom < model.body_geomadr[id] + model.body_geomnum[id]; ++geom) {
      const double center = data.geom_xpos[3 * geom + 2];
      const double half = engine::half_height(model, data, geom);
      low = std::min(low, center - half);
      high = std::max(high, center + half);
    }
  }
  if (!(high > low)) return {0, 0};
  return {low, high};
}

double height(const mjModel& model, const mjData& data, const Body& body) {
  const Extent reach = extent(model, data, body);
  return reach.high - reach.low;
}

// Agents that are no infants: parts of models that know nothing of the library.

Body find_part(const mjModel& model, const std::string& root) {
  Body body;
  body.infant = false;
  body.root = engine::find_or_fail(model, Kind::kBody, root);
  body.bodies = subtree(model, body.root);
  if (body.root == 0) body.bodies.erase(body.bodies.begin());
  for (int id = 0; id < model.njnt; ++id) {
    if (engine::has_one_axis(model, id) && body.has(model.jnt_bodyid[id])) body.joints.push_back(joint(model, id));
  }
  for (int id = 0; id < model.nu; ++id) {
    if (body.has(body_of_actuator(model, id))) body.actuators.push_back(id);
  }
  for (int id = 0; id < model.nsensor; ++id) {
    const bool torque = model.sensor_type[id] == mjSENS_TORQUE;
    if (torque && body.has(model.site_bodyid[model.sensor_objid[id]])) body.torques.push_back(sensor(model, id));
  }
  return body;
}

std::pair<double, double> forces_of(const mjModel& model, int motor) {
  if (model.actuator_forcelimited[motor] != 0) {
    return {model.actuator_forcerange[2 * motor], model.actuator_forcerange[2 * motor + 1]};
  }
  const double gain = model.actuator_gaintype[motor] == mjGAIN_FIXED ? model.actuator_gainprm[mjNGAIN * motor] : 0;
  const double* controls = model.actuator_ctrlrange + 2 * motor;
  if (model.actuator_ctrllimited[motor] == 0) return {0, 0};
  return {std::min(gain * controls[0], gain * controls[1]), std::max(gain * controls[0], gain * controls[1])};
}

std::pair<double, double> muscle_range(const mjModel& model, const Body& body, const Joint& joint) {
  const std::string name = body.prefix + names::kBornRanges;
  const Span<const double> numbers = engine::custom_numbers(model, name);
  if (numbers.empty() || model.jnt_type[joint.id] != mjJNT_HINGE) return {joint.low, joint.high};
  const Place place = place_of(model, body, joint.id);
  if (numbers.size() != 2 * place.of) {
    fail(Status::kModel, "numeric {} has {} numbers, expected two for each of the infant's {} hinges", name,
         numbers.size(), place.of);
  }
  const double low = numbers[2 * place.number], high = numbers[2 * place.number + 1];
  if (!(low < high && std::isfinite(low) && std::isfinite(high))) {
    fail(Status::kModel, "numeric {}: joint \"{}\" goes from {} to {}, expected a range", name,
         engine::name(model, engine::Kind::kJoint, joint.id), low, high);
  }
  const double wider = 0.5 * ((high - low) - (joint.high - joint.low));
  constexpr double kSame = 1e-9;  // rad; what a document is rounded to
  if (!(std::abs(wider) > kSame) || !std::isfinite(wider)) return {joint.low, joint.high};
  return {joint.low - wider, joint.high + wider};
}

void read_stored_pose(const mjModel& model, Span<double> qpos) {
  visit_named(engine::custom_number_names(model), names::kRootPose,
              [&](const std::string& name, const std::string& prefix) {
                const Span<const double> pose = engine::custom_numbers(model, name);
                const int body = engine::find(model, engine::Kind::kBody, (prefix + names::kRootBody).c_str());
                if (pose.size() == 7 && body >= 0) place_root(model, body, pose, qpos);
              });
  visit_named(engine::custom_tuple_names(model), names::kPose, [&](const std::string& name, const std::string&) {
    for (const engine::TupleEntry& entry : engine::custom_tuple(model, name, engine::Kind::kJoint)) {
      if (!engine::has_one_axis(model, entry.id)) {
        fail(Status::kModel, "{}: joint {} is not a hinge or slide", name,
             engine::name(model, engine::Kind::kJoint, entry.id));
      }
      qpos[static_cast<std::size_t>(model.jnt_qposadr[entry.id])] = entry.value;
    }
  });
}

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
