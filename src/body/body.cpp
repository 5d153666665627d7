#include "body/body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"
#include "engine/custom.h"
#include "engine/ground.h"
#include "engine/joints.h"

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

}  // namespace mimo::body
