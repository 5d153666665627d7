#include "env/succession.h"

namespace mimo::env {

std::unique_ptr<World> make_world(const Kit& kit, const Services& services, const Identity& identity) {
  return std::make_unique<World>(kit.model, kit.agents, kit.options, services, identity);
}

void take_over(std::unique_ptr<World>& place, std::unique_ptr<World> next, const std::uint64_t* seed,
               std::uint8_t* block) {
  place->require_ready_to_reset();
  next->succeed(*place);
  place.swap(next);  // before the reset, as tasks of the user's own ask for the world that is there
  try {
    place->reset(seed, block);
  } catch (...) {
    place.swap(next);
    throw;
  }
  place->take_listener(*next);
}

}  // namespace mimo::env
