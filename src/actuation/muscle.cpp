#include "actuation/muscle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/fail.h"
#include "base/functions.h"
#include "body/body.h"
#include "engine/present.h"

namespace mimo::actuation::curves {
namespace {

constexpr double cube(double x) { return x * x * x; }

// A smooth bump of four parabolas: 0 at and beyond `low` and `high`, 1 at `middle`.
double bump(double x, double low, double middle, double high) {
  if (x <= low || x >= high) return 0;
  const double left = (low + middle) / 2;
  const double right = (middle + high) / 2;
  if (x < left) return square((x - low) / (left - low)) / 2;
  if (x < middle) return 1 - square((middle - x) / (middle - left)) / 2;
  if (x < right) return 1 - square((x - middle) / (right - middle)) / 2;
  return square((high - x) / (high - right)) / 2;
}

}  // namespace

double force_length(double length) {
  constexpr double kShoulder = 0.95;
  return bump(length, kShortest, 1, kLongest) + 0.15 * bump(length, kShortest, (kShortest + kShoulder) / 2, kShoulder);
}

double force_velocity(double velocity) {
  constexpr double kGain = kStretched - 1;
  if (velocity < -1) return 0;
  if (velocity <= 0) return square(velocity + 1);
  if (velocity <= kGain) return kStretched - square(kGain - velocity) / kGain;
  return kStretched;
}

double passive_force(double length) {
  constexpr double kBend = (kLongest + 1) / 2;  // from here on it grows linearly
  constexpr double kScale = 0.25 * kPassive;
  if (length <= 1) return 0;
  if (length <= kBend) return kScale * cube((length - 1) / (kBend - 1));
  return kScale * (1 + 3 * (length - kBend) / (kBend - 1));
}

}  // namespace mimo::actuation::curves

namespace mimo::actuation {
namespace {

using engine::Kind;

constexpr double kTimeConstant = 0.01;        // s, of the original's activation
constexpr double kRise = 0.01, kFall = 0.04;  // s, of MuJoCo's
constexpr double kDampingLeft = 1.0 / 20;     // of the joint's damper, which stood for muscles
constexpr double kTiny = 1e-10;               // keeps a joint without range from dividing by zero

// The original's numbers of a motor: fastest shortening, peak forces to the negative and to the positive side.
constexpr int kNumbers = 3;

const double* numbers_of(const mjModel& model, int motor) {
  const char* name = engine::name(model, Kind::kActuator, motor);
  if (model.nuser_actuator < kNumbers) {
    fail(Status::kUnsupported, "muscles: {} has {} user numbers, expected {}", name, model.nuser_actuator, kNumbers);
  }
  const double* numbers = model.actuator_user + model.nuser_actuator * motor;
  for (int i = 0; i < kNumbers; ++i) {
    if (!(numbers[i] > 0)) {
      fail(Status::kUnsupported, "muscles: user number {} of {} is {}, expected more than 0", i, name, numbers[i]);
    }
  }
  if (model.actuator_gear[6 * motor] == 0) fail(Status::kUnsupported, "muscles: the gear of {} is 0", name);
  return numbers;
}

}  // namespace

Muscle::Muscle(const mjModel& model, const body::Body& body, bool normalize) : Actuation(normalize) {
  for (const body::Motor& motor : body::motors(model, body)) {
    const double* numbers = numbers_of(model, motor.id);
    Joint joint{motor.joint, motor.id, model.actuator_gear[6 * motor.id], model.qpos_spring[motor.joint.qpos],
                numbers[0]};
    if (!std::isfinite(motor.joint.low)) {
      fail(Status::kUnsupported, "muscles: joint {} of {} has no range",
           engine::name(model, Kind::kJoint, motor.joint.id), engine::name(model, Kind::kActuator, motor.id));
    }
    const auto [shortest, longest] = body::muscle_range(model, body, motor.joint);
    const double low = shortest - joint.rest, high = longest - joint.rest;
    const double range = curves::kAtLongEnd - curves::kAtShortEnd + kTiny;
    Side& negative = joint.sides[0];
    negative.slope = range / (high - low + kTiny);
    negative.offset = curves::kAtShortEnd - negative.slope * low;
    negative.peak_force = numbers[1];
    Side& positive = joint.sides[1];
    positive.slope = -negative.slope;
    positive.offset = curves::kAtShortEnd - positive.slope * high;
    positive.peak_force = numbers[2];
    joints_.push_back(joint);
  }
  for (const char* side : {"/negative", "/positive"}) {
    for (const int id : body.actuators) add(engine::name(model, Kind::kActuator, id) + std::string(side), 0, 1);
  }
  for (const body::Joint& joint : body.joints) {
    dampers_.push_back({joint.id, joint.dof, kDampingLeft * model.dof_damping[joint.dof]});
  }
}

void Muscle::reset(engine::Physics& physics) {
  for (const Damper& damper : dampers_) physics.slacken(damper.joint, damper.dof, damper.damping);
  for (Joint& joint : joints_) {
    physics.unlimit(joint.motor);
    for (Side& side : joint.sides) side.activation = side.target = 0;
  }
}

void Muscle::command(std::size_t index, double value, engine::Physics&) { side(index).target = value; }

double Muscle::commanded(std::size_t index, const engine::Physics&) const { return side(index).target; }

void Muscle::pull(std::size_t motor, double share, double* offsets) const {
  offsets[share > 0 ? motor + joints_.size() : motor] += std::abs(share);
}

double Muscle::force(const Joint& joint, const Side& side, const mjData& data) const {
  const double length = side.slope * (data.qpos[joint.joint.qpos] - joint.rest) + side.offset;
  const double velocity = side.slope * data.qvel[joint.joint.dof];
  return force(side, length, velocity, joint.fastest);
}

void Muscle::advance(engine::Physics& physics) {
  mjData& data = physics.data();
  const double seconds = physics.model().opt.timestep;
  for (Joint& joint : joints_) {
    double torque = 0;
    for (Side& side : joint.sides) {
      side.activation = std::clamp(activated(side, seconds), 0.0, 1.0);
      torque -= side.slope * force(joint, side, data);
    }
    data.ctrl[joint.motor] = torque / joint.gear;
  }
}

bool Muscle::pulls(const mjData& data, double* shares) const {
  for (std::size_t i = 0; i < commands(); ++i) {
    shares[i] = std::max(0.0, force(joint(i), side(i), data) / side(i).peak_force);
  }
  return true;
}

double Muscle::effort(const mjModel&, const mjData&) const {
  double spent = 0, most = 0;
  for (const Joint& joint : joints_) {
    for (const Side& side : joint.sides) {
      spent += side.activation * side.activation * side.peak_force;
      most += side.peak_force;
    }
  }
  return most > 0 ? spent / (static_cast<double>(commands()) * most) : 0;
}

Feedback Muscle::feel(const mjModel& model, const body::Body&) const {
  observation::Field activation;
  activation.name = "proprioception/activation";
  activation.shape = {commands()};
  activation.frame = "actuator";
  activation.time = observation::Time::kEnd;
  activation.low = 0;
  activation.high = 1;
  activation.labels = names();
  for (std::size_t i = 0; i < commands(); ++i) activation.bodies.push_back(model.jnt_bodyid[joint(i).joint.id]);
  observation::Field strength = activation;
  strength.name = "proprioception/muscle_force";
  strength.high = std::numeric_limits<double>::infinity();
  const auto activations = [this](const mjModel&, const mjData&, float* out) {
    for (std::size_t i = 0; i < commands(); ++i) out[i] = static_cast<float>(side(i).activation);
  };
  const auto forces = [this](const mjModel&, const mjData& data, float* out) {
    for (std::size_t i = 0; i < commands(); ++i) out[i] = static_cast<float>(force(joint(i), side(i), data));
  };
  return {{}, {{activation, activations}, {strength, forces}}};
}

void Muscle::save(ByteWriter& to) const {
  for (const Joint& joint : joints_) {
    for (const Side& side : joint.sides) {
      to.put(side.activation);
      to.put(side.target);
    }
  }
}

void Muscle::load(ByteReader& from) {
  const auto take = [&](const char* what) {
    const double value = from.take_finite(what);
    require(value >= 0 && value <= 1, "the state holds {} for {}, expected 0 to 1", value, what);
    return value;
  };
  for (Joint& joint : joints_) {
    for (Side& side : joint.sides) {
      side.activation = take("an activation");
      side.target = take("a muscle's target");
    }
  }
}

double MimoMuscle::activated(const Side& side, double seconds) const {
  return side.activation + seconds * (side.target - side.activation) / kTimeConstant;
}

double MimoMuscle::force(const Side& side, double length, double velocity, double fastest) const {
  const double active = side.activation * curves::force_length(length) * curves::force_velocity(velocity / fastest);
  return side.peak_force * (active + curves::passive_force(length));
}

double MujocoMuscle::activated(const Side& side, double seconds) const {
  return side.activation + seconds * engine::muscle_activation_rate(side.target, side.activation, kRise, kFall);
}

double MujocoMuscle::force(const Side& side, double length, double velocity, double fastest) const {
  const engine::MuscleShape shape = {curves::kAtShortEnd, curves::kAtLongEnd, side.peak_force,
                                     curves::kShortest,   curves::kLongest,   fastest,
                                     curves::kPassive,    curves::kStretched};
  return side.activation * engine::muscle_active_force(shape, length, velocity) +
         engine::muscle_passive_force(shape, length);
}

}  // namespace mimo::actuation
