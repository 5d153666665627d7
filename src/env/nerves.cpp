#include "env/nerves.h"

#include <algorithm>

#include "body/nerves.h"
#include "growth/eyesight.h"

namespace mimo::env {
namespace {

using observation::Field;
using observation::Share;

// Of nerves that end in the brain stem, and in the cortex; thin ones are slower.
double late(const growth::Conduction& nerves, double metres, const Field& field) {
  const bool slow = field.nerve_speed > 0 && nerves.speed > 0;
  return (slow ? metres / field.nerve_speed : nerves.along(metres) / field.nerve_share) + nerves.sensory;
}

std::vector<double> of_receptors(const Field& field, const growth::Conduction& nerves,
                                 const std::vector<double>& lengths) {
  const std::size_t width = field.count() / field.receptors.size();
  std::vector<double> delays;
  delays.reserve(field.count());
  for (const observation::Receptor& receptor : field.receptors) {
    delays.insert(delays.end(), width, late(nerves, lengths[static_cast<std::size_t>(receptor.body)], field));
  }
  return delays;
}

std::vector<double> of_bodies(const Field& field, const growth::Conduction& nerves,
                              const std::vector<double>& lengths) {
  std::vector<double> delays;
  for (const int body : field.bodies) delays.push_back(late(nerves, lengths[static_cast<std::size_t>(body)], field));
  return delays;
}

std::vector<double> delays_of(const Field& field, Share share, const growth::Conduction& nerves,
                              const std::vector<double>& lengths) {
  if (share == Share::kVision) return {nerves.vision};
  if (share == Share::kVestibular) return {nerves.vestibular};
  if (!field.receptors.empty()) return of_receptors(field, nerves, lengths);
  return of_bodies(field, nerves, lengths);
}

// What was asked for by itself, or with the age.
Maturity maturity_of(const AgentOptions& options) {
  if (options.maturity) return *options.maturity;
  const growth::Growth& growth = options.growth;
  Maturity maturity;
  if (growth.eyes) {
    const growth::Eyesight eyes = growth::eyesight_at(growth.physiological_age);
    maturity.eyes = {eyes.acuity, eyes.peak_contrast, eyes.chroma};
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
  if (!is.eyes.any() && !is.nerves.any()) return {};
  return [is, &agent, lengths = body::nerve_lengths(model, agent.body)](const Field& field) {
    const auto its = std::find_if(agent.senses.begin(), agent.senses.end(),
                                  [&field](const auto& sense) { return sense->has(field); });
    if (its == agent.senses.end()) return observation::Nature{};
    const Share share = (*its)->share();
    return observation::Nature{is.nerves.any() ? delays_of(field, share, is.nerves, lengths) : std::vector<double>{},
                               share == Share::kVision ? is.eyes : observation::Eyesight{}};
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
