#include "actuation/additions.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"

namespace mimo::actuation {

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
