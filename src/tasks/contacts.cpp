#include "tasks/contacts.h"

#include <algorithm>

namespace mimo::tasks {
namespace {

struct Pair {
  int first, second;
  bool has(int body) const { return first == body || second == body; }
};

Pair bodies_of(const engine::Physics& physics, int contact) {
  const mjContact& found = physics.data().contact[contact];
  const int* body = physics.model().geom_bodyid;
  return {body[found.geom1], body[found.geom2]};
}

bool presses(const engine::Physics& physics, int contact) {
  const auto force = engine::contact_force(physics.model(), physics.data(), contact);
  return std::any_of(force.begin(), force.begin() + 3, [](double component) { return component != 0; });
}

}  // namespace

bool touches(const engine::Physics& physics, const std::vector<int>& bodies, int other) {
  for (int i = 0; i < physics.data().ncon; ++i) {
    const Pair pair = bodies_of(physics, i);
    if (!pair.has(other)) continue;
    const int toucher = pair.first == other ? pair.second : pair.first;
    if (std::find(bodies.begin(), bodies.end(), toucher) != bodies.end() && presses(physics, i)) return true;
  }
  return false;
}

bool feels(const engine::Physics& physics, int body) {
  for (int i = 0; i < physics.data().ncon; ++i) {
    if (bodies_of(physics, i).has(body) && presses(physics, i)) return true;
  }
  return false;
}

}  // namespace mimo::tasks
