#include "senses/proprioception.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/bits.h"
#include "base/header.h"

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

Signal position(const mjModel& model, const body::Body& body, double /*threshold*/) {
  const Joints& joints = body.joints;
  return {joint_field(model, joints, "position", body::units_of(model, joints).position, Time::kEnd),
          [joints](const mjModel&, const mjData& data, float* out) {
            for (const body::Joint& joint : joints) *out++ = static_cast<float>(data.qpos[joint.qpos]);
          }};
}

Signal velocity(const mjModel& model, const body::Body& body, double /*threshold*/) {
  const Joints& joints = body.joints;
  return {joint_field(model, joints, "velocity", body::units_of(model, joints).velocity, Time::kEnd),
          [joints](const mjModel&, const mjData& data, float* out) {
            for (const body::Joint& joint : joints) *out++ = static_cast<float>(data.qvel[joint.dof]);
          }};
}

// Three axes at each joint sensor.
Signal torque(const mjModel& model, const body::Body& body, double /*threshold*/) {
  const std::vector<body::Sensor>& sensors = body.torques;
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
Signal limit(const mjModel& model, const body::Body& body, double threshold) {
  const Joints& joints = body.joints;
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
Signal joint_torque(const mjModel& model, const body::Body& body, double /*threshold*/) {
  const Joints& joints = body.joints;
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

struct Row {
  std::uint32_t bit;
  Signal (*make)(const mjModel& model, const body::Body& body, double threshold);
};

// In the order of their fields; those of commands lie between the two tables, those of receptors behind them.
constexpr Row kFirst[] = {
    {MIMO_PROPRIOCEPTION_POSITION, position},
    {MIMO_PROPRIOCEPTION_VELOCITY, velocity},
    {MIMO_PROPRIOCEPTION_TORQUE, torque},
    {MIMO_PROPRIOCEPTION_LIMIT, limit},
};
constexpr Row kLast[] = {{MIMO_PROPRIOCEPTION_JOINT_TORQUE, joint_torque}};
static_assert((bits_of(kFirst) | bits_of(kLast) | kMuscleReceptors | MIMO_PROPRIOCEPTION_ACTUATION |
               MIMO_PROPRIOCEPTION_EFFORT) == header::kProprioception);

}  // namespace

std::unique_ptr<observation::Sense> make_proprioception(const mjModel& model, const body::Body& body,
                                                        const ProprioceptionOptions& options,
                                                        std::vector<Signal> commands, Pulls pulls,
                                                        std::shared_ptr<FusimotorDrives> drives, double tick) {
  std::vector<Signal> signals;
  const auto add = [&](const Row& row) {
    if (has_bit(options.wanted, row.bit)) signals.push_back(row.make(model, body, options.limit_threshold));
  };
  for (const Row& row : kFirst) add(row);
  std::move(commands.begin(), commands.end(), std::back_inserter(signals));
  for (const Row& row : kLast) add(row);
  MuscleReceptors receptors = make_muscle_receptors(model, body, options.wanted, options.limit_threshold,
                                                    std::move(pulls), std::move(drives), tick);
  std::move(receptors.signals.begin(), receptors.signals.end(), std::back_inserter(signals));
  auto sense = std::make_unique<observation::Signals>(observation::Share::kProprioception, std::move(signals));
  for (auto& process : receptors.processes) sense->keep(std::move(process));
  return sense;
}

}  // namespace mimo::senses
