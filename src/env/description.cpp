#include "env/description.h"

namespace mimo::env {
namespace {

// What is late was true some steps before.
Interval time_of(const observation::Field& field, const observation::LimitedSenses& limits, double timestep,
                 double period) {
  const double physics = field.time == observation::Time::kEnd ? 0 : timestep;
  const double at = 0 - physics - static_cast<double>(limits.delay(field)) * period;
  return {at, at};
}

// What worlds and attached senses have in common.
template <typename Observing>
Description describe_senses(const Observing& observing) {
  const observation::Layout& layout = observing.layout();
  const double period = observing.step_seconds();
  Description description{layout, {}, period, observing.agents().size(), {}, {}};
  for (std::size_t i = 0; i < layout.size(); ++i) {
    description.times.push_back(time_of(layout[i], observing.limits(), observing.model().opt.timestep, period));
  }
  return description;
}

void add_actions(const actuation::Actuation& actuation, std::size_t agent, std::vector<Action>& actions) {
  for (std::size_t i = 0; i < actuation.size(); ++i) {
    actions.push_back({actuation.names()[i].c_str(), actuation.units()[i], agent,
                       static_cast<double>(actuation.low()[i]), static_cast<double>(actuation.high()[i])});
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

}  // namespace mimo::env
