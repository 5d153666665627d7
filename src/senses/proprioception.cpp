#include "senses/proprioception.h"

#include <algorithm>
#include <utility>

namespace mimo::senses {
namespace {

using engine::Kind;

std::vector<std::string> names(const mjModel& model, const std::vector<body::Joint>& joints) {
  std::vector<std::string> labels;
  for (const body::Joint& joint : joints) labels.emplace_back(engine::name(model, Kind::kJoint, joint.id));
  return labels;
}

std::vector<std::string> names(const mjModel& model, const std::vector<int>& actuators) {
  std::vector<std::string> labels;
  for (const int id : actuators) labels.emplace_back(engine::name(model, Kind::kActuator, id));
  return labels;
}

// One label per axis: "proprio:neck/x".
std::vector<std::string> axis_names(const mjModel& model, const std::vector<body::Sensor>& sensors) {
  std::vector<std::string> labels;
  for (const body::Sensor& sensor : sensors) {
    for (const char* axis : {"/x", "/y", "/z"}) {
      labels.push_back(engine::name(model, Kind::kSensor, sensor.id) + std::string(axis));
    }
  }
  return labels;
}

Field field(const char* name, std::vector<std::size_t> shape, const char* unit, const char* frame, Time time,
            std::vector<std::string> labels) {
  Field field;
  field.name = std::string("proprioception/") + name;
  field.shape = std::move(shape);
  field.unit = unit;
  field.frame = frame;
  field.time = time;
  field.labels = std::move(labels);
  return field;
}

struct Units {
  const char *position, *velocity, *force;
};

// Infants have hinges only; other agents may have slides.
Units units_of(const mjModel& model, const std::vector<body::Joint>& joints) {
  const auto slides = [&](const body::Joint& joint) { return model.jnt_type[joint.id] == mjJNT_SLIDE; };
  if (std::none_of(joints.begin(), joints.end(), slides)) return {"rad", "rad/s", "Nm"};
  if (std::all_of(joints.begin(), joints.end(), slides)) return {"m", "m/s", "N"};
  return {"rad or m", "rad/s or m/s", "Nm or N"};
}

}  // namespace

Proprioception::Proprioception(const mjModel& model, body::Body body, const ProprioceptionOptions& options)
    : body_(std::move(body)), threshold_(options.limit_threshold) {
  const std::size_t joints = body_.joints.size();
  const std::size_t motors = body_.actuators.size();
  const Units units = units_of(model, body_.joints);
  using P = Proprioception;
  if (options.position) {
    add(field("position", {joints}, units.position, "joint", Time::kEnd, names(model, body_.joints)),
        &P::write_position);
  }
  if (options.velocity) {
    add(field("velocity", {joints}, units.velocity, "joint", Time::kEnd, names(model, body_.joints)),
        &P::write_velocity);
  }
  if (options.torque && !body_.torques.empty()) {
    add(field("torque", {body_.torques.size(), 3}, "Nm", "site", Time::kLastStart, axis_names(model, body_.torques)),
        &P::write_torque);
  }
  if (options.limit) {
    Field limit = field("limit", {joints}, "", "joint", Time::kEnd, names(model, body_.joints));
    limit.low = 0;
    add(std::move(limit), &P::write_limit);
  }
  if (options.actuation && options.position_control) {
    for (const body::Motor& motor : body::motors(model, body_)) locks_.push_back(motor.lock);
    add(field("target", {motors}, units.position, "joint", Time::kEnd, names(model, body_.actuators)),
        &P::write_target);
  } else if (options.actuation && motors > 0) {
    add(field("control", {motors}, "", "actuator", Time::kEnd, names(model, body_.actuators)), &P::write_control);
    if (body_.infant) {
      add(field("motor_torque", {motors}, "Nm", "joint", Time::kEnd, names(model, body_.actuators)),
          &P::write_motor_torque);
    } else {  // whose actuators may be servos or muscles
      add(field("actuator_force", {motors}, "N or Nm", "actuator", Time::kLastStart, names(model, body_.actuators)),
          &P::write_actuator_force);
    }
  }
  if (options.joint_torque) {
    add(field("joint_torque", {joints}, units.force, "joint", Time::kLastStart, names(model, body_.joints)),
        &P::write_joint_torque);
  }
}

void Proprioception::add(Field field, Writer writer) {
  if (field.count() == 0) return;
  fields_.push_back(std::move(field));
  writers_.push_back(writer);
}

void Proprioception::write(const mjModel& model, const mjData& data, std::uint8_t* block) {
  for (std::size_t i = 0; i < writers_.size(); ++i) (this->*writers_[i])(model, data, at<float>(block, i));
}

void Proprioception::write_position(const mjModel&, const mjData& data, float* out) const {
  for (const body::Joint& joint : body_.joints) *out++ = static_cast<float>(data.qpos[joint.qpos]);
}

void Proprioception::write_velocity(const mjModel&, const mjData& data, float* out) const {
  for (const body::Joint& joint : body_.joints) *out++ = static_cast<float>(data.qvel[joint.dof]);
}

void Proprioception::write_torque(const mjModel&, const mjData& data, float* out) const {
  for (const body::Sensor& sensor : body_.torques) {
    for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(data.sensordata[sensor.address + axis]);
  }
}

// 0 when more than the threshold inside both limits, 1 at a limit, more beyond it.
void Proprioception::write_limit(const mjModel&, const mjData& data, float* out) const {
  for (const body::Joint& joint : body_.joints) {
    const double angle = data.qpos[joint.qpos];
    const double inside = std::min(angle - (joint.low + threshold_), (joint.high - threshold_) - angle) / threshold_;
    *out++ = static_cast<float>(std::max(0.0, -inside));
  }
}

void Proprioception::write_control(const mjModel&, const mjData& data, float* out) const {
  for (const int id : body_.actuators) *out++ = static_cast<float>(data.ctrl[id]);
}

void Proprioception::write_motor_torque(const mjModel& model, const mjData& data, float* out) const {
  for (const int id : body_.actuators) {
    *out++ = static_cast<float>(model.actuator_gear[6 * id] * data.ctrl[id]);
  }
}

void Proprioception::write_actuator_force(const mjModel&, const mjData& data, float* out) const {
  for (const int id : body_.actuators) *out++ = static_cast<float>(data.actuator_force[id]);
}

void Proprioception::write_target(const mjModel& model, const mjData&, float* out) const {
  for (const int lock : locks_) *out++ = static_cast<float>(engine::lock_angle(model, lock));
}

// The force that the parent exerts on the body, as seen along the joint's degree of freedom: what motor, spring,
// damper, friction and limit of the joint give together. Both are MuJoCo's spatial vectors about the same point.
void Proprioception::write_joint_torque(const mjModel& model, const mjData& data, float* out) const {
  for (const body::Joint& joint : body_.joints) {
    const double* axis = data.cdof + 6 * joint.dof;
    const double* force = data.cfrc_int + 6 * model.jnt_bodyid[joint.id];
    double torque = 0;
    for (int i = 0; i < 6; ++i) torque += axis[i] * force[i];
    *out++ = static_cast<float>(torque);
  }
}

}  // namespace mimo::senses
