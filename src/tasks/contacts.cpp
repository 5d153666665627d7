#include "tasks/contacts.h"

#include <algorithm>

#include "engine/contacts.h"

namespace mimo::tasks {
namespace {

bool presses(const engine::Physics& physics, int contact) {
  const auto force = engine::contact_force(physics.model(), physics.data(), contact);
  return std::any_of(force.begin(), force.begin() + 3, [](double component) { return component != 0; });
}

}  // namespace

bool touches(const engine::Physics& physics, const std::vector<int>& bodies, int other) {
  for (const engine::Meeting& met : engine::Contacts(physics.model(), physics.data())) {
    const auto [first, second] = met.bodies;
    if (first != other && second != other) continue;
    const int toucher = first == other ? second : first;
    if (std::find(bodies.begin(), bodies.end(), toucher) != bodies.end() && presses(physics, met.number)) return true;
  }
  return false;
}

bool feels(const engine::Physics& physics, int body) {
  for (const engine::Meeting& met : engine::Contacts(physics.model(), physics.data())) {
    const bool its = met.bodies[0] == body || met.bodies[1] == body;
    if (its && presses(physics, met.number)) return true;
  }
  return false;
}

}  // namespace mimo::tasks
