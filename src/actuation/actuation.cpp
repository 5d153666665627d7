#include "actuation/actuation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "actuation/joint_control.h"
#include "actuation/muscle.h"
#include "base/fail.h"
#include "base/numbers.h"

namespace mimo::actuation {

observation::Field actuator_field(const mjModel& model, const std::vector<int>& actuators, const char* name) {
  observation::Field field;
  field.name = std::string("proprioception/") + name;
  field.shape = {actuators.size()};
  field.frame = "actuator";
  field.time = observation::Time::kEnd;
  for (const int id : actuators) {
    field.labels.emplace_back(engine::name(model, engine::Kind::kActuator, id));
    field.bodies.push_back(body::moved_by(model, id));
  }
  return field;
}

void Actuation::add(std::string name, double low, double high, const char* unit) {
  ranges_.push_back({low, high});
  low_.push_back(normalize_ ? -1.0f : static_cast<float>(low));
  high_.push_back(normalize_ ? 1.0f : static_cast<float>(high));
  names_.push_back(std::move(name));
  units_.push_back(normalize_ ? "" : unit);
}

void Actuation::add_control(std::string name, double low, double high, const char* unit,
                            std::shared_ptr<double> number) {
  add(std::move(name), low, high, unit);
  controls_.push_back(std::move(number));
}

void Actuation::apply(Span<const float> actions, engine::Physics& physics) {
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    if (std::isnan(actions[i])) continue;
    double value = static_cast<double>(std::clamp(actions[i], low_[i], high_[i]));
    if (normalize_) value = ranges_[i].low + (value + 1) / 2 * (ranges_[i].high - ranges_[i].low);
    if (i < commands()) {
      command(i, value, physics);
    } else {
      *controls_[i - commands()] = value;
    }
  }
}

Feedback Actuation::feedback(const mjModel& model, const body::Body& body, std::uint32_t felt) const {
  Feedback feedback;
  if (has_bit(felt, MIMO_PROPRIOCEPTION_ACTUATION)) feedback = feel(model, body);
  if (!has_bit(felt, MIMO_PROPRIOCEPTION_EFFORT)) return feedback;
  observation::Field field;
  field.name = "proprioception/effort";
  field.shape = {1};
  field.time = observation::Time::kEnd;
  field.low = 0;
  field.labels = {"effort"};
  feedback.exertion.push_back({field, [this](const mjModel& model_now, const mjData& data, float* out) {
                                 *out = static_cast<float>(effort(model_now, data));
                               }});
  return feedback;
}

std::unique_ptr<Actuation> make_actuation(const mjModel& model, const body::Body& agent, const Options& options) {
  body::Body body = agent;
  if (options.none) body.actuators.clear();
  switch (options.mode) {
    case Mode::kPosition: return std::make_unique<Position>(model, body, options.normalize);
    case Mode::kMuscle: return std::make_unique<MimoMuscle>(model, body, options.normalize);
    case Mode::kMujocoMuscle: return std::make_unique<MujocoMuscle>(model, body, options.normalize);
    case Mode::kTorque: return std::make_unique<Torque>(model, body, options.normalize);
  }
  fail(Status::kInvalidArgument, "actuation mode is {}, expected 0 to 3", static_cast<int>(options.mode));
}

Additions::Additions(const mjModel& model, const body::Body& body, Actuation& actuation)
    : actuation_(actuation),
      offsets_(actuation.commands()),
      asked_(actuation.commands()),
      given_(actuation.commands()) {
  if (actuation.commands() == 0) return;
  for (const body::Motor& motor : body::motors(model, body)) locks_.push_back(motor.lock);
}

void Additions::follow(Span<const float> actions, const engine::Physics& physics) {
  if (!adding_) return;
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    if (!std::isnan(actions[i])) asked_[i] = given_[i] = actuation_.commanded(i, physics);
  }
}

// A lock that the agent's own actions move does not hinder it.
bool Additions::held(std::size_t motor, const mjModel& model) const {
  const int lock = locks_[motor];
  return lock >= 0 && engine::is_held(model, lock) && !actuation_.holds(lock);
}

void Additions::add(Span<const double> shares, engine::Physics& physics) {
  std::fill(offsets_.begin(), offsets_.end(), 0.0);
  for (std::size_t motor = 0; motor < locks_.size(); ++motor) {
    if (shares[motor] == 0 || held(motor, physics.model())) continue;
    actuation_.pull(motor, std::clamp(shares[motor], -1.0, 1.0), offsets_.data());
  }
  for (std::size_t i = 0; i < offsets_.size(); ++i) set(i, offsets_[i], physics);
  adding_ = true;
}

void Additions::stop(engine::Physics& physics) {
  if (!adding_) return;
  for (std::size_t i = 0; i < offsets_.size(); ++i) set(i, 0, physics);
  adding_ = false;
}

// Whatever stands there that was not given here is a command of somebody else's: a host that sets controls.
void Additions::set(std::size_t action, double offset, engine::Physics& physics) {
  const double now = actuation_.commanded(action, physics);
  if (!adding_ || now != given_[action]) asked_[action] = now;
  const Actuation::Range& range = actuation_.range(action);
  const double wanted = offset == 0 ? asked_[action] : std::clamp(asked_[action] + offset, range.low, range.high);
  if (wanted != now) actuation_.command(action, wanted, physics);
  given_[action] = actuation_.commanded(action, physics);
}

void Additions::save(ByteWriter& to) const {
  to.put(adding_);
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    to.put(adding_ ? asked_[i] : 0.0);
    to.put(adding_ ? given_[i] : 0.0);
  }
}

void Additions::load(ByteReader& from) {
  adding_ = from.take_flag();
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    asked_[i] = from.take_finite("a command");
    given_[i] = from.take_finite("a command");
  }
}

}  // namespace mimo::actuation
