#include "env/access.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/fail.h"

namespace mimo::env {
namespace {

using engine::Kind;

// How a quantity is stored: whose it is, how wide, and whether it can be written.
struct Traits {
  const char* name;
  Kind kind;
  int width;  // 0: depends on the element
  bool writable;
};

const Traits& traits(Quantity quantity) {
  static constexpr std::array<Traits, 22> kTraits = {{
      {"joint position", Kind::kJoint, 0, true},      {"joint velocity", Kind::kJoint, 0, true},
      {"joint force", Kind::kJoint, 0, true},         {"joint acceleration", Kind::kJoint, 0, false},
      {"joint range", Kind::kJoint, 2, false},        {"body position", Kind::kBody, 3, true},
      {"body orientation", Kind::kBody, 4, true},     {"body velocity", Kind::kBody, 6, false},
      {"body force", Kind::kBody, 6, true},           {"body mass", Kind::kBody, 1, false},
      {"body center of mass", Kind::kBody, 3, false}, {"geom position", Kind::kGeom, 3, false},
      {"geom orientation", Kind::kGeom, 4, false},    {"geom size", Kind::kGeom, 3, false},
      {"site position", Kind::kSite, 3, false},       {"site orientation", Kind::kSite, 4, false},
      {"camera position", Kind::kCamera, 3, false},   {"camera orientation", Kind::kCamera, 4, false},
      {"actuator control", Kind::kActuator, 1, true}, {"actuator force", Kind::kActuator, 1, false},
      {"sensor value", Kind::kSensor, 0, false},      {"actuator gear", Kind::kActuator, 1, true},
  }};
  return kTraits[static_cast<std::size_t>(quantity) - 1];
}

int position_width(int joint_type) { return joint_type == mjJNT_FREE ? 7 : joint_type == mjJNT_BALL ? 4 : 1; }

int velocity_width(int joint_type) { return joint_type == mjJNT_FREE ? 6 : joint_type == mjJNT_BALL ? 3 : 1; }

int width(const mjModel& model, Quantity quantity, int id) {
  if (quantity == Quantity::kJointPosition) return position_width(model.jnt_type[id]);
  if (quantity == Quantity::kSensorValue) return model.sensor_dim[id];
  const int fixed = traits(quantity).width;
  return fixed > 0 ? fixed : velocity_width(model.jnt_type[id]);
}

// The free joint of a body, by which it can be moved; -1 if it has none.
int free_joint(const mjModel& model, int body) {
  const int joint = model.body_jntadr[body];
  return joint >= 0 && model.jnt_type[joint] == mjJNT_FREE ? joint : -1;
}

bool moves_bodies(Quantity quantity) {
  return quantity == Quantity::kJointPosition || quantity == Quantity::kBodyPosition ||
         quantity == Quantity::kBodyOrientation;
}

// Where a quantity that MuJoCo stores as plain numbers lies; null for those that are computed.
const double* stored(const mjModel& model, const mjData& data, Quantity quantity, int id) {
  switch (quantity) {
    case Quantity::kJointPosition: return data.qpos + model.jnt_qposadr[id];
    case Quantity::kJointVelocity: return data.qvel + model.jnt_dofadr[id];
    case Quantity::kJointForce: return data.qfrc_applied + model.jnt_dofadr[id];
    case Quantity::kJointAcceleration: return data.qacc + model.jnt_dofadr[id];
    case Quantity::kBodyPosition: return data.xpos + 3 * id;
    case Quantity::kBodyOrientation: return data.xquat + 4 * id;
    case Quantity::kBodyForce: return data.xfrc_applied + 6 * id;
    case Quantity::kBodyMass: return model.body_mass + id;
    case Quantity::kBodyCenterOfMass: return data.xipos + 3 * id;
    case Quantity::kGeomPosition: return data.geom_xpos + 3 * id;
    case Quantity::kGeomSize: return model.geom_size + 3 * id;
    case Quantity::kSitePosition: return data.site_xpos + 3 * id;
    case Quantity::kCameraPosition: return data.cam_xpos + 3 * id;
    case Quantity::kActuatorControl: return data.ctrl + id;
    case Quantity::kActuatorForce: return data.actuator_force + id;
    case Quantity::kSensorValue: return data.sensordata + model.sensor_adr[id];
    case Quantity::kActuatorGear: return model.actuator_gear + 6 * id;
    default: return nullptr;
  }
}

void compute(const mjModel& model, const mjData& data, Quantity quantity, int id, double* out) {
  const auto put = [out](const auto& values) { std::copy(values.begin(), values.end(), out); };
  switch (quantity) {
    case Quantity::kJointRange:
      if (model.jnt_limited[id] != 0) {
        std::copy_n(model.jnt_range + 2 * id, 2, out);
      } else {
        out[1] = std::numeric_limits<double>::infinity();
        out[0] = -out[1];
      }
      break;
    case Quantity::kBodyVelocity: put(engine::body_velocity(model, data, id)); break;
    case Quantity::kGeomOrientation: put(engine::quaternion(data.geom_xmat + 9 * id)); break;
    case Quantity::kSiteOrientation: put(engine::quaternion(data.site_xmat + 9 * id)); break;
    case Quantity::kCameraOrientation: put(engine::quaternion(data.cam_xmat + 9 * id)); break;
    default: break;
  }
}

// Where a writable quantity is written to.
double* target(engine::Physics& physics, Quantity quantity, int id) {
  const mjModel& model = physics.model();
  mjData& data = physics.data();
  switch (quantity) {
    case Quantity::kJointPosition: return data.qpos + model.jnt_qposadr[id];
    case Quantity::kJointVelocity: return data.qvel + model.jnt_dofadr[id];
    case Quantity::kJointForce: return data.qfrc_applied + model.jnt_dofadr[id];
    case Quantity::kBodyPosition: return data.qpos + model.jnt_qposadr[free_joint(model, id)];
    case Quantity::kBodyOrientation: return data.qpos + model.jnt_qposadr[free_joint(model, id)] + 3;
    case Quantity::kBodyForce: return data.xfrc_applied + 6 * id;
    case Quantity::kActuatorControl: return data.ctrl + id;
    case Quantity::kActuatorGear: return &physics.gear(id);
    default: return nullptr;
  }
}

// The quaternion among the values of one element, if there is one.
double* quaternion_in(const mjModel& model, Quantity quantity, int id, double* values) {
  if (quantity == Quantity::kBodyOrientation) return values;
  if (quantity != Quantity::kJointPosition) return nullptr;
  if (model.jnt_type[id] == mjJNT_BALL) return values;
  return model.jnt_type[id] == mjJNT_FREE ? values + 3 : nullptr;
}

double norm(const double* q) { return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]); }

// Numbers whose squares are too large for a double have a direction too.
void normalise(double* q) {
  if (std::isinf(norm(q))) {
    for (int i = 0; i < 4; ++i) q[i] *= 1e-200;
  }
  const double length = norm(q);
  for (int i = 0; i < 4; ++i) q[i] /= length;
}

}  // namespace

engine::Kind kind_from(int number) {
  require(number >= 1 && number <= 7, "kind is {}, expected MIMO_BODY (1) to MIMO_SENSOR (7)", number);
  return static_cast<Kind>(number);
}

Quantity quantity_from(int number) {
  require(number >= 1 && number <= 22, "quantity is {}, expected MIMO_JOINT_POSITION (1) to MIMO_ACTUATOR_GEAR (22)",
          number);
  return static_cast<Quantity>(number);
}

int body_of(const mjModel& model, Kind kind, int id) {
  switch (kind) {
    case Kind::kBody: return model.body_parentid[id];
    case Kind::kJoint: return model.jnt_bodyid[id];
    case Kind::kGeom: return model.geom_bodyid[id];
    case Kind::kSite: return model.site_bodyid[id];
    case Kind::kCamera: return model.cam_bodyid[id];
    default:
      fail(Status::kInvalidArgument, "kind is {} ({}), expected body, joint, geom, site or camera",
           static_cast<int>(kind), engine::word(kind));
  }
}

std::size_t width(const mjModel& model, Quantity quantity, Span<const std::int32_t> ids) {
  const Kind kind = traits(quantity).kind;
  const int limit = engine::count(model, kind);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    require(ids[i] >= 0 && ids[i] < limit, "ids[{}] is {}, expected a {} id from 0 to {}", i, ids[i],
            engine::word(kind), limit - 1);
    sum += static_cast<std::size_t>(width(model, quantity, ids[i]));
  }
  return sum;
}

void get(const engine::Physics& physics, Quantity quantity, Span<const std::int32_t> ids, Span<double> values) {
  const mjModel& model = physics.model();
  const mjData& data = physics.data();
  double* out = values.data();
  for (const std::int32_t id : ids) {
    const int count = width(model, quantity, id);
    const double* from = stored(model, data, quantity, id);
    if (from != nullptr) {
      std::copy_n(from, count, out);
    } else {
      compute(model, data, quantity, id, out);
    }
    out += count;
  }
}

void require_writable(Quantity quantity) {
  const Traits& what = traits(quantity);
  require(what.writable, "quantity {} ({}) can only be read", static_cast<int>(quantity), what.name);
}

void check_settable(const mjModel& model, Quantity quantity, Span<const std::int32_t> ids, Span<const double> values) {
  require_writable(quantity);
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(std::isfinite(values[i]), "values[{}] is {}, expected a finite number", i, values[i]);
  }
  const bool body = quantity == Quantity::kBodyPosition || quantity == Quantity::kBodyOrientation;
  const double* at = values.data();
  for (const std::int32_t id : ids) {
    if (body && free_joint(model, id) < 0) {
      fail(Status::kInvalidArgument, "body {} (\"{}\") cannot be moved: it has no free joint", id,
           engine::name(model, Kind::kBody, id));
    }
    const double* quat = quaternion_in(model, quantity, id, const_cast<double*>(at));
    require(quat == nullptr || norm(quat) > 1e-9, "values: the quaternion of {} {} is zero",
            word(traits(quantity).kind), id);
    at += width(model, quantity, id);
  }
}

void set(engine::Physics& physics, Quantity quantity, Span<const std::int32_t> ids, Span<const double> values) {
  physics.require_usable();
  const mjModel& model = physics.model();
  check_settable(model, quantity, ids, values);
  const double* from = values.data();
  for (const std::int32_t id : ids) {
    const int count = width(model, quantity, id);
    double* to = target(physics, quantity, id);
    std::copy_n(from, count, to);
    double* quat = quaternion_in(model, quantity, id, to);
    if (quat != nullptr) normalise(quat);
    from += count;
  }
  if (moves_bodies(quantity)) physics.update_poses();
}

Contact contact(const mjModel& model, const mjData& data, int index) {
  const mjContact& touch = data.contact[index];
  Contact contact;
  contact.ids = {touch.geom1, touch.geom2, model.geom_bodyid[touch.geom1], model.geom_bodyid[touch.geom2]};
  double* at = contact.values.data();
  at = std::copy_n(touch.pos, 3, at);
  at = std::copy_n(touch.frame, 9, at);
  *at++ = touch.dist;
  const auto force = engine::contact_force(model, data, index);
  std::copy(force.begin(), force.end(), at);
  return contact;
}

}  // namespace mimo::env
