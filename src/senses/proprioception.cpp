#include "senses/proprioception.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/fail.h"
#include "base/functions.h"
#include "base/header.h"
#include "base/numbers.h"
#include "body/body.h"
#include "receptors/muscles.h"
#include "senses/fusimotor_drives.h"

namespace mimo::senses {
namespace {

using observation::Field;
using observation::Signal;
using observation::Time;
using receptors::TendonOrgan;

// A motor that turns a joint with a range: two muscles.
struct Pair {
  int motor;
  body::Joint joint;
  double weakest, strongest;  // forces of the motor, negative and positive
  double low, high;           // angles where its muscles are at their shortest and longest
};

std::vector<Pair> pairs_of(const mjModel& model, const body::Body& body) {
  std::vector<Pair> pairs;
  for (const int motor : body.actuators) {
    if (model.actuator_trntype[motor] != mjTRN_JOINT) continue;
    const int joint = model.actuator_trnid[2 * motor];
    const int type = model.jnt_type[joint];
    if ((type != mjJNT_HINGE && type != mjJNT_SLIDE) || model.jnt_limited[joint] == 0) continue;
    if (!(model.jnt_range[2 * joint] < model.jnt_range[2 * joint + 1])) continue;
    const auto [weakest, strongest] = body::forces_of(model, motor);
    const body::Joint turned = body::joint(model, joint);
    const auto [low, high] = body::muscle_range(model, body, turned);
    pairs.push_back({motor, turned, weakest, strongest, low, high});
  }
  return pairs;
}

Field muscle_field(const mjModel& model, const std::vector<Pair>& pairs, const char* name, Time time) {
  Field field;
  field.name = std::string("proprioception/") + name;
  field.shape = {2 * pairs.size()};
  field.unit = "Hz";
  field.frame = "actuator";
  field.time = time;
  field.low = 0;
  for (const char* side : {"/negative", "/positive"}) {
    for (const Pair& pair : pairs) {
      field.labels.push_back(engine::name(model, engine::Kind::kActuator, pair.motor) + std::string(side));
      field.bodies.push_back(model.jnt_bodyid[pair.joint.id]);
    }
  }
  return field;
}

class Spindles : public observation::Process {
 public:
  Spindles(std::vector<Pair> pairs, std::shared_ptr<FusimotorDrives> drives, double tick)
      : Process("spindles"),
        pairs_(std::move(pairs)),
        drives_(std::move(drives)),
        tick_(tick),
        spindles_(2 * pairs_.size()) {}

  Signal signal(const mjModel& model, const char* name, double receptors::SpindleRates::*part) const {
    return {muscle_field(model, pairs_, name, Time::kEnd), [this, part](const mjModel&, const mjData&, float* out) {
              for (const receptors::Spindle& spindle : spindles_) *out++ = static_cast<float>(spindle.rates().*part);
            }};
  }

 private:
  // The muscle that pulls to the negative side is long where the angle is large.
  double length(std::size_t muscle, const mjData& data) const {
    using receptors::kLongestMuscle;
    using receptors::kShortestMuscle;
    const bool negative = muscle < pairs_.size();
    const Pair& pair = pairs_[negative ? muscle : muscle - pairs_.size()];
    const double angle = data.qpos[pair.joint.qpos];
    const double up = (kLongestMuscle - kShortestMuscle) * (angle - pair.low) / (pair.high - pair.low);
    return negative ? kShortestMuscle + up : kLongestMuscle - up;
  }
  void rest(const mjModel&, const mjData& data) override {
    for (std::size_t i = 0; i < spindles_.size(); ++i) spindles_[i].rest(length(i, data), drives_->all()[i]);
  }
  void go_on(const mjModel&, const mjData& data) override {
    for (std::size_t i = 0; i < spindles_.size(); ++i) spindles_[i].advance(length(i, data), drives_->all()[i], tick_);
  }
  void save(ByteWriter& to) const override {
    drives_->save(to);
    for (const receptors::Spindle& spindle : spindles_) spindle.save(to);
  }
  void load(ByteReader& from) override {
    drives_->load(from);
    for (receptors::Spindle& spindle : spindles_) spindle.load(from);
  }

  std::vector<Pair> pairs_;
  std::shared_ptr<FusimotorDrives> drives_;
  receptors::SpindleTick tick_;
  std::vector<receptors::Spindle> spindles_;
};

class TendonOrgans : public observation::Process {
 public:
  TendonOrgans(std::vector<Pair> pairs, Pulls pulls, double tick)
      : Process("tendon organs"),
        pairs_(std::move(pairs)),
        pulls_(std::move(pulls)),
        kept_slow_(fixed::exp(-TendonOrgan::kSlow * tick)),
        kept_fast_(fixed::exp(-TendonOrgan::kFast * tick)),
        organs_(2 * pairs_.size()),
        shares_(2 * pairs_.size()) {}

  Signal signal(const mjModel& model) const {
    return {muscle_field(model, pairs_, "tendon_organ", Time::kLastStart),
            [this](const mjModel&, const mjData&, float* out) {
              for (const TendonOrgan& organ : organs_) *out++ = static_cast<float>(organ.rate());
            }};
  }

 private:
  void measure(const mjData& data) {
    if (pulls_ && pulls_(data, shares_.data())) return;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Pair& pair = pairs_[i];
      const double force = data.actuator_force[pair.motor];
      shares_[i] = pair.weakest < 0 ? std::max(0.0, force / pair.weakest) : 0;
      shares_[pairs_.size() + i] = pair.strongest > 0 ? std::max(0.0, force / pair.strongest) : 0;
    }
  }
  void rest(const mjModel&, const mjData& data) override {
    measure(data);
    for (std::size_t i = 0; i < organs_.size(); ++i) organs_[i].rest(shares_[i]);
  }
  void go_on(const mjModel&, const mjData& data) override {
    measure(data);
    for (std::size_t i = 0; i < organs_.size(); ++i) organs_[i].advance(shares_[i], kept_slow_, kept_fast_);
  }
  void save(ByteWriter& to) const override {
    for (const TendonOrgan& organ : organs_) organ.save(to);
  }
  void load(ByteReader& from) override {
    for (TendonOrgan& organ : organs_) organ.load(from);
  }

  std::vector<Pair> pairs_;
  Pulls pulls_;
  double kept_slow_, kept_fast_;
  std::vector<TendonOrgan> organs_;
  std::vector<double> shares_;
};

// Two numbers a joint: near its lower, and near its upper limit.
Signal joint_receptors(const mjModel& model, const std::vector<body::Joint>& joints, double threshold) {
  Field field;
  field.name = "proprioception/joint_receptor";
  field.shape = {joints.size(), 2};
  field.unit = "Hz";
  field.frame = "joint";
  field.time = Time::kEnd;
  field.low = 0;
  for (const body::Joint& joint : joints) {
    for (const char* end : {"/low", "/high"}) {
      field.labels.push_back(engine::name(model, engine::Kind::kJoint, joint.id) + std::string(end));
      field.bodies.push_back(model.jnt_bodyid[joint.id]);
    }
  }
  return {field, [joints, threshold](const mjModel&, const mjData& data, float* out) {
            for (const body::Joint& joint : joints) {
              const double at = data.qpos[joint.qpos], speed = data.qvel[joint.dof] / threshold;
              const double low = (joint.low + threshold - at) / threshold;
              const double high = (at - joint.high + threshold) / threshold;
              *out++ = static_cast<float>(receptors::joint_receptor(low, -speed));
              *out++ = static_cast<float>(receptors::joint_receptor(high, speed));
            }
          }};
}

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

std::shared_ptr<FusimotorDrives> make_fusimotor_drives(const mjModel& model, const body::Body& body) {
  std::vector<int> motors;
  for (const Pair& pair : pairs_of(model, body)) motors.push_back(pair.motor);
  return std::make_shared<FusimotorDrives>(motors);
}

MuscleReceptors make_muscle_receptors(const mjModel& model, const body::Body& body, std::uint32_t wanted,
                                      double limit_threshold, Pulls pulls, std::shared_ptr<FusimotorDrives> drives,
                                      double tick) {
  const std::vector<Pair> pairs = pairs_of(model, body);
  MuscleReceptors made;
  if (has_bit(wanted, kSpindles)) {
    using receptors::SpindleRates;
    auto spindles = std::make_unique<Spindles>(pairs, std::move(drives), tick);
    const auto add = [&](std::uint32_t bit, const char* name, double SpindleRates::*part) {
      if (has_bit(wanted, bit)) made.signals.push_back(spindles->signal(model, name, part));
    };
    add(MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY, "spindle_primary", &SpindleRates::primary);
    add(MIMO_PROPRIOCEPTION_SPINDLE_SECONDARY, "spindle_secondary", &SpindleRates::secondary);
    made.processes.push_back(std::move(spindles));
  }
  if (has_bit(wanted, MIMO_PROPRIOCEPTION_TENDON_ORGAN)) {
    auto organs = std::make_unique<TendonOrgans>(pairs, std::move(pulls), tick);
    made.signals.push_back(organs->signal(model));
    made.processes.push_back(std::move(organs));
  }
  if (has_bit(wanted, MIMO_PROPRIOCEPTION_JOINT_RECEPTOR)) {
    made.signals.push_back(joint_receptors(model, body.joints, limit_threshold));
  }
  return made;
}

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
