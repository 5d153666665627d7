#include "senses/proprioception.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mimo::senses {
namespace {

using engine::Kind;
using observation::Field;
using observation::Signal;
using observation::Time;
using Joints = std::vector<body::Joint>;

std::vector<std::string> names(const mjModel& model, const Joints& joints) {
  std::vector<std::string> labels;
  for (const body::Joint& joint : joints) labels.emplace_back(engine::name(model, Kind::kJoint, joint.id));
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

// A field with one number for each joint.
Field joint_field(const mjModel& model, const Joints& joints, const char* name, const char* unit, Time time) {
  Field field;
  field.name = std::string("proprioception/") + name;
  field.shape = {joints.size()};
  field.unit = unit;
  field.frame = "joint";
  field.time = time;
  field.labels = names(model, joints);
  for (const body::Joint& joint : joints) field.bodies.push_back(model.jnt_bodyid[joint.id]);
  return field;
}

Signal position(const mjModel& model, const Joints& joints) {
  return {joint_field(model, joints, "position", body::units_of(model, joints).position, Time::kEnd),
          [joints](const mjModel&, const mjData& data, float* out) {
            for (const body::Joint& joint : joints) *out++ = static_cast<float>(data.qpos[joint.qpos]);
          }};
}

Signal velocity(const mjModel& model, const Joints& joints) {
  return {joint_field(model, joints, "velocity", body::units_of(model, joints).velocity, Time::kEnd),
          [joints](const mjModel&, const mjData& data, float* out) {
            for (const body::Joint& joint : joints) *out++ = static_cast<float>(data.qvel[joint.dof]);
          }};
}

Signal torque(const mjModel& model, const std::vector<body::Sensor>& sensors) {
  Field field;
  field.name = "proprioception/torque";
  field.shape = {sensors.size(), 3};
  field.unit = "Nm";
  field.frame = "site";
  field.time = Time::kLastStart;
  field.labels = axis_names(model, sensors);
  for (const body::Sensor& sensor : sensors) {
    field.bodies.insert(field.bodies.end(), 3, model.site_bodyid[model.sensor_objid[sensor.id]]);
  }
  return {field, [sensors](const mjModel&, const mjData& data, float* out) {
            for (const body::Sensor& sensor : sensors) {
              for (int axis = 0; axis < 3; ++axis) *out++ = static_cast<float>(data.sensordata[sensor.address + axis]);
            }
          }};
}

// 0 when more than the threshold inside both limits, 1 at a limit, more beyond it.
Signal limit(const mjModel& model, const Joints& joints, double threshold) {
  Field field = joint_field(model, joints, "limit", "", Time::kEnd);
  field.low = 0;
  return {field, [joints, threshold](const mjModel&, const mjData& data, float* out) {
            for (const body::Joint& joint : joints) {
              const double at = data.qpos[joint.qpos];
              const double inside = std::min(at - (joint.low + threshold), (joint.high - threshold) - at) / threshold;
              *out++ = static_cast<float>(std::max(0.0, -inside));
            }
          }};
}

// The force that the parent exerts on the body, as seen along the joint's degree of freedom: what motor, spring,
// damper, friction and limit of the joint give together. Both are MuJoCo's spatial vectors about the same point.
Signal joint_torque(const mjModel& model, const Joints& joints) {
  return {joint_field(model, joints, "joint_torque", body::units_of(model, joints).force, Time::kLastStart),
          [joints](const mjModel& now, const mjData& data, float* out) {
            for (const body::Joint& joint : joints) {
              const double* axis = data.cdof + 6 * joint.dof;
              const double* force = data.cfrc_int + 6 * now.jnt_bodyid[joint.id];
              double torque = 0;
              for (int i = 0; i < 6; ++i) torque += axis[i] * force[i];
              *out++ = static_cast<float>(torque);
            }
          }};
}

}  // namespace

std::unique_ptr<observation::Sense> make_proprioception(const mjModel& model, const body::Body& body,
                                                        const ProprioceptionOptions& options,
                                                        std::vector<Signal> commands, Pulls pulls, double tick) {
  std::vector<Signal> signals;
  if (options.position) signals.push_back(position(model, body.joints));
  if (options.velocity) signals.push_back(velocity(model, body.joints));
  if (options.torque) signals.push_back(torque(model, body.torques));
  if (options.limit) signals.push_back(limit(model, body.joints, options.limit_threshold));
  std::move(commands.begin(), commands.end(), std::back_inserter(signals));
  if (options.joint_torque) signals.push_back(joint_torque(model, body.joints));
  MuscleReceptors receptors =
      make_muscle_receptors(model, body, options.receptors, options.limit_threshold, std::move(pulls), tick);
  std::move(receptors.signals.begin(), receptors.signals.end(), std::back_inserter(signals));
  auto sense = std::make_unique<observation::Signals>(observation::Share::kProprioception, std::move(signals));
  if (receptors.process != nullptr) sense->keep(std::move(receptors.process));
  return sense;
}

}  // namespace mimo::senses
