#include "env/nerves.h"

#include <algorithm>
#include <optional>

#include "base/fail.h"
#include "base/format.h"
#include "body/nerves.h"
#include "growth/eyesight.h"

namespace mimo::env {
namespace {

using observation::Field;
using observation::Share;

// How late an agent feels the parts of its body.
class Ways {
 public:
  Ways(const mjModel& model, const body::Body& body, const growth::Conduction& nerves, const PartDelays& given)
      : nerves_(nerves), lengths_(body::nerve_lengths(model, body)), given_(static_cast<std::size_t>(model.nbody)) {
    if (given.everywhere) given_.assign(given_.size(), given.everywhere);
    for (const auto& [name, seconds] : given.parts) given_[body_of(model, body, name)] = seconds;
  }

  double to(int part, const Field& field) const {
    const auto id = static_cast<std::size_t>(part);
    return given_[id].value_or(nerves_.any() ? late(lengths_[id], field) : 0);
  }
  const growth::Conduction& nerves() const { return nerves_; }

 private:
  // Of nerves that end in the brain stem, and from there to the cortex; thin ones are slower.
  double late(double metres, const Field& field) const {
    const bool slow = field.nerve_speed > 0 && nerves_.speed > 0;
    return (slow ? metres / field.nerve_speed : nerves_.along(metres) / field.nerve_share) + nerves_.sensory;
  }

  static std::size_t body_of(const mjModel& model, const body::Body& body, const std::string& name) {
    std::vector<std::string> there;
    for (const int id : body.bodies) {
      if (body::short_name(model, body, id) == name) return static_cast<std::size_t>(id);
      there.push_back(body::short_name(model, body, id));
    }
    fail(Status::kNotFound, "sensory delay: the agent has no body \"{}\"; it has: {}", name, join(there, ", "));
  }

  growth::Conduction nerves_;
  std::vector<double> lengths_;
  std::vector<std::optional<double>> given_;  // by body
};

std::vector<double> of_receptors(const Field& field, const Ways& ways) {
  const std::size_t width = field.count() / field.receptors.size();
  std::vector<double> delays;
  delays.reserve(field.count());
  for (const observation::Receptor& receptor : field.receptors) {
    delays.insert(delays.end(), width, ways.to(receptor.body, field));
  }
  return delays;
}

std::vector<double> delays_of(const Field& field, Share share, const Ways& ways) {
  if (share == Share::kVision) return {ways.nerves().vision};
  if (share == Share::kVestibular) return {ways.nerves().vestibular};
  if (share == Share::kHearing) return {ways.nerves().hearing};
  if (!field.receptors.empty()) return of_receptors(field, ways);
  std::vector<double> delays;
  for (const int body : field.bodies) delays.push_back(ways.to(body, field));
  return delays;
}

// What was asked for by itself, or with the age.
Maturity maturity_of(const AgentOptions& options) {
  if (options.maturity) return *options.maturity;
  const growth::Growth& growth = options.growth;
  Maturity maturity;
  if (growth.eyes) {
    const growth::Eyesight eyes = growth::eyesight_at(growth.physiological_age);
    maturity.eyes = {eyes.acuity, eyes.peak_contrast, eyes.chroma, growth.flicker ? eyes.flicker : 0, growth.threshold};
  }
  if (growth.delays) maturity.nerves = growth::conduction_at(growth.physiological_age);
  return maturity;
}

// The actuator that an action commands, or a muscle of which it is.
int actuator_of(const mjModel& model, const body::Body& body, const std::string& action) {
  for (const int id : body.actuators) {
    const std::string name = engine::name(model, engine::Kind::kActuator, id);
    if (action == name || action.compare(0, name.size() + 1, name + "/") == 0) return id;
  }
  return -1;
}

}  // namespace

observation::NatureOf nature_of_senses(const mjModel& model, const Perception& agent, const AgentOptions& options) {
  const Maturity is = maturity_of(options);
  const bool late = is.nerves.any() || options.delays.any();
  if (!is.eyes.any() && !late) return {};
  return [late, eyes = is.eyes, &agent, ways = Ways(model, agent.body, is.nerves, options.delays)](const Field& field) {
    const auto its = std::find_if(agent.senses.begin(), agent.senses.end(),
                                  [&field](const auto& sense) { return sense->has(field); });
    if (its == agent.senses.end()) return observation::Nature{};
    const Share share = (*its)->share();
    return observation::Nature{late ? delays_of(field, share, ways) : std::vector<double>{},
                               share == Share::kVision ? eyes : observation::Eyesight{}};
  };
}

std::vector<double> motor_delays(const mjModel& model, const body::Body& body, const actuation::Actuation& actuation,
                                 const AgentOptions& options) {
  const growth::Conduction nerves = maturity_of(options).nerves;
  if (!nerves.any()) return {};
  const std::vector<double> lengths = body::nerve_lengths(model, body);
  std::vector<double> delays;
  for (const std::string& action : actuation.names()) {
    const int actuator = actuator_of(model, body, action);
    const int part = actuator < 0 ? 0 : body::moved_by(model, actuator);
    delays.push_back(part == 0 ? 0 : nerves.along(lengths[static_cast<std::size_t>(part)]) + nerves.motor);
  }
  return delays;
}

}  // namespace mimo::env
