#include "actuation/actuation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "actuation/muscle.h"
#include "actuation/position.h"
#include "actuation/torque.h"
#include "base/bits.h"
#include "base/fail.h"

namespace mimo::actuation {

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

}  // namespace mimo::actuation
