#include "env/description.h"

#include <algorithm>

#include "base/fail.h"

namespace mimo::env {
namespace {

// What is late was true some time before.
Interval time_of(const observation::Field& field, const observation::Lateness& late, double timestep) {
  const double at = field.time == observation::Time::kEnd ? 0 : -timestep;
  return {at - static_cast<double>(late.most()) * late.tick, at - static_cast<double>(late.least()) * late.tick};
}

// What worlds and attached senses have in common.
template <typename Observing>
Description describe_senses(const Observing& observing) {
  const observation::Layout& layout = observing.layout();
  Description description;
  description.block_bytes = layout.bytes();
  description.period = observing.step_seconds();
  description.agents = observing.agents().size();
  for (const Perception& agent : observing.agents()) description.skins.push_back(agent.skin);
  const double timestep = observing.model().opt.timestep;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    description.fields.push_back(layout[i]);
    const observation::DelayLine* delay = observing.limits().delay(layout[i]);
    description.delays.push_back(delay == nullptr ? observation::Lateness{} : delay->lateness());
    description.times.push_back(time_of(layout[i], description.delays.back(), timestep));
  }
  return description;
}

void add_actions(const actuation::Actuation& actuation, std::size_t agent, std::vector<Action>& actions) {
  for (std::size_t i = 0; i < actuation.size(); ++i) {
    actions.push_back({actuation.names()[i], actuation.units()[i], agent, static_cast<double>(actuation.low()[i]),
                       static_cast<double>(actuation.high()[i])});
  }
}

void check_count(const char* what, std::size_t expected, std::size_t count) {
  require(count == expected, "there are {} {}, expected {}", count, what, expected);
}

std::string shape_of(const observation::Field& field) {
  std::string text;
  for (const std::size_t extent : field.shape) text += (text.empty() ? "" : " x ") + std::to_string(extent);
  return text;
}

void check_alike(const observation::Field& expected, const observation::Field& other) {
  require(other.name == expected.name, "a field is \"{}\", expected \"{}\"", other.name, expected.name);
  require(other.shape == expected.shape, "field \"{}\" has shape {}, expected {}", other.name, shape_of(other),
          shape_of(expected));
  require(other.type == expected.type && other.unit == expected.unit && other.frame == expected.frame &&
              other.labels == expected.labels,
          "field \"{}\" has other elements than expected", other.name);
}

template <typename Bounded>
void widen_bounds(std::vector<Bounded>& ours, const std::vector<Bounded>& others) noexcept {
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ours[i].low = std::min(ours[i].low, others[i].low);
    ours[i].high = std::max(ours[i].high, others[i].high);
  }
}

template <typename Bounded>
void take_bounds(std::vector<Bounded>& ours, const std::vector<Bounded>& others) noexcept {
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ours[i].low = others[i].low;
    ours[i].high = others[i].high;
  }
}

}  // namespace

Description describe(const World& world) {
  Description description = describe_senses(world);
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents()[i];
    add_actions(*agent.actuation, i, description.actions);
    for (const tasks::Term& term : agent.task->terms()) description.terms.push_back({term.name, i});
  }
  return description;
}

Description describe(const Attached& attached) { return describe_senses(attached); }

void check_alike(const Description& expected, const Description& other) {
  check_count("fields", expected.fields.size(), other.fields.size());
  for (std::size_t i = 0; i < expected.fields.size(); ++i) check_alike(expected.fields[i], other.fields[i]);
  check_count("actions", expected.actions.size(), other.actions.size());
  for (std::size_t i = 0; i < expected.actions.size(); ++i) {
    const Action &ours = expected.actions[i], &theirs = other.actions[i];
    require(theirs.name == ours.name && theirs.agent == ours.agent, "an action is \"{}\", expected \"{}\"", theirs.name,
            ours.name);
  }
  check_count("terms of rewards", expected.terms.size(), other.terms.size());
}

void LiveDescription::widen(const Description& other) noexcept {
  const std::lock_guard lock(mutex_);
  widen_bounds(description_.fields, other.fields);
  widen_bounds(description_.actions, other.actions);
}

void LiveDescription::adopt(Description&& other) noexcept {
  const std::lock_guard lock(mutex_);
  take_bounds(description_.fields, other.fields);
  take_bounds(description_.actions, other.actions);
  for (std::size_t i = 0; i < description_.fields.size(); ++i) {
    description_.fields[i].receptors = other.fields[i].receptors;
    description_.fields[i].own_receptors = std::move(other.fields[i].own_receptors);
  }
  description_.skins = std::move(other.skins);
  description_.times = std::move(other.times);
  description_.delays = std::move(other.delays);
}

}  // namespace mimo::env
